#include "app/command.hpp"
#include "app/gl_context.hpp"
#include "app/ignored_options.hpp"
#include "app/progress.hpp"
#include "core/render/renderer.hpp"
#include "core/support/error.hpp"
#include "core/support/output_file.hpp"

namespace momentscope {

namespace {

class Render : public ParsedCommand {
public:
    explicit Render(CLI::App& app) : ParsedCommand(app) {
        add_scene(app, scene_);
        add_size(app, size_);
        add_gl(app);
        add_techniques(app, techniques_, "id of a technique, or a configuration such as at:nodes=8");
        app.add_option("-o,--output", output_, ".exr (linear floats) or .png")->required();
        parameters_.add_to(app);
    }

    void refuse_ignored() const override {
        refuse_ignored_parameters(parameters_, {.techniques = techniques_in(configurations()),
                                                .picture = true,
                                                .order = true,
                                                .tone_map = ends_in(output_, ".png"),
                                                .mesh = has_mesh_file(scene_)});
    }

    FileUse files() const override { return {scene_files(scene_), {{"-o", output_}}}; }

    void run() const override {
        const auto configurations = this->configurations();
        if (configurations.size() != 1)
            throw Error("A picture is drawn with one technique; give a single --technique.");
        if (!ends_in(output_, ".png") && !ends_in(output_, ".exr"))
            throw Error("A picture is a .png or .exr file; give -o such a name.");
        require_writable(output_);  // fail before the work, not after it
        write_image(drawn(configurations.front()), output_, tone_map_of(parameters_.over()));
    }

private:
    std::vector<Configuration> configurations() const {
        return configurations_of(techniques_, "power6-32", parameters_.over());
    }

    Image drawn(const Configuration& configuration) const {
        Progress progress("Drawing");
        const Scene scene = load_scene_and_warn(scene_, parameters_.over(), progress);
        const auto context = make_headless_context({16, 16});
        Renderer renderer;
        renderer.set_scene(scene);
        renderer.render({scene.camera, size_, configuration.technique, configuration.values});
        Image picture = renderer.read_picture();
        progress.require_finished();
        return picture;
    }

    std::string scene_ = STANDARD_SCENE;
    glm::ivec2 size_ = PICTURE_SIZE;
    TechniqueIds techniques_;
    std::string output_;
    ParameterOptions parameters_;
};

}  // namespace

std::unique_ptr<ParsedCommand> add_render(CLI::App& app) {
    return std::make_unique<Render>(app);
}

}  // namespace momentscope
