#include "app/commands.hpp"
#include "app/gl_context.hpp"
#include "app/progress.hpp"
#include "core/error.hpp"
#include "core/output_file.hpp"
#include "core/render/renderer.hpp"

namespace momentscope {

namespace {

Image drawn(const Options& options, const ParameterValues& parameters, const Configuration& configuration,
            glm::ivec2 size) {
    Progress progress("Drawing");
    const Scene scene = load_scene_option(options, parameters, progress);
    const auto context = make_gl_context("osmesa", {16, 16});
    Renderer renderer;
    renderer.set_scene(scene);
    renderer.render({scene.camera, size, configuration.technique, configuration.values});
    Image picture = renderer.read_picture();
    progress.require_finished();
    return picture;
}

}  // namespace

void run_render(const Options& options) {
    const glm::ivec2 size = parse_size(options.size.empty() ? STANDARD_SIZE : options.size);
    const ParameterValues parameters = parse_parameters(options);
    const auto configurations = parse_configurations(options, "power6-32");
    if (configurations.size() != 1)
        throw Error("A picture is drawn by one technique; give a single --technique.");
    const std::string extension = std::filesystem::path(options.output).extension();
    if (extension != ".png" && extension != ".exr")
        throw Error("A picture ends in .png or .exr; give -o such a name.");
    require_writable(options.output);  // before the work, not after
    write_image(drawn(options, parameters, configurations.front(), size), options.output,
                tone_map_of(parameters));
}

}  // namespace momentscope
