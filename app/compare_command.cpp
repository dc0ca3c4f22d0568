#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/commands.hpp"
#include "app/gl_context.hpp"
#include "app/terminal.hpp"
#include "core/compare/difference.hpp"
#include "core/compare/false_color.hpp"
#include "core/error.hpp"
#include "core/output_file.hpp"
#include "core/parse_number.hpp"
#include "core/render/renderer.hpp"

namespace momentscope {

namespace {

PixelRegion parse_region(const std::string& text, const Image& image) {
    if (text.empty()) return {0, 0, image.width, image.height};
    constexpr int MOST = 99'999;  // pixels, so that sums are safe
    std::vector<int> numbers;
    for (const std::string& part : split_list({text})) {
        const auto number = parse_number<int>(part);
        if (number && *number >= 0 && *number <= MOST) numbers.push_back(*number);
    }
    if (numbers.size() != 4 || split_list({text}).size() != 4)
        throw Error(fmt::format("'{}' is no region; give x,y,width,height in pixels, as 10,20,64,48.", text));
    const PixelRegion region = {numbers[0], numbers[1], numbers[2], numbers[3]};
    if (region.width < 1 || region.height < 1 || region.x + region.width > image.width ||
        region.y + region.height > image.height)
        throw Error(fmt::format("The region {} does not lie within pictures of {}x{}.", text, image.width,
                                image.height));
    return region;
}

/// Pictures from files, or drawn here by a technique.
class Pictures {
public:
    explicit Pictures(const Options& options) : options_(options), parameters_(parse_parameters(options)) {}

    Image get(const std::string& name) {
        if (find_technique(name.substr(0, name.find(':'))) == nullptr) return read_image(name);
        const Configuration configuration = parse_configuration(name, parameters_);
        if (renderer_ == nullptr) {
            scene_ = load_scene_option(options_, parameters_);
            context_ = make_gl_context("osmesa", {16, 16});
            renderer_ = std::make_unique<Renderer>();
            renderer_->set_scene(scene_);
        }
        const glm::ivec2 size = parse_size(options_.size.empty() ? STANDARD_SIZE : options_.size);
        renderer_->render({scene_.camera, size, configuration.technique, configuration.values});
        return renderer_->read_picture();
    }

private:
    const Options& options_;
    ParameterValues parameters_;
    Scene scene_;
    std::unique_ptr<GlContext> context_;
    std::unique_ptr<Renderer> renderer_;  // after the context that it needs
};

// A single NaN would make every metric NaN.
void require_finite(const Image& image, const std::string& name) {
    std::size_t count = 0, first = 0;
    for (std::size_t i = image.pixels.size(); i-- > 0;) {
        const glm::vec4& pixel = image.pixels[i];
        if (std::isfinite(pixel.r) && std::isfinite(pixel.g) && std::isfinite(pixel.b)) continue;
        ++count;
        first = i;
    }
    if (count == 0) return;
    const auto width = static_cast<std::size_t>(image.width);
    throw Error(
        fmt::format("{} of the {} pixels of '{}' are infinite or NaN, the first at {},{}; such pictures "
                    "cannot be compared.",
                    count, image.pixels.size(), name, first % width, first / width));
}

// What the metrics, which look at colours alone, leave out.
std::string note_on_alpha(const Image& reference, const Image& test) {
    float most = 0, least = 1;
    for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
        most = std::max(most, std::abs(reference.pixels[i].a - test.pixels[i].a));
        least = std::min({least, reference.pixels[i].a, test.pixels[i].a});
    }
    if (least >= 1 && most == 0) return "";
    return fmt::format(
        "alpha: colours are compared as they are stored, whatever their alpha, which differs by {:.6g} at "
        "most.",
        most);
}

}  // namespace

void run_compare(const Options& options) {
    const MetricRow* only = options.metric.empty() ? nullptr : &require_metric(options.metric);
    if (!options.output.empty()) {
        if (only == nullptr) throw Error("A map shows one metric; give --metric beside -o.");
        if (std::filesystem::path(options.output).extension() != ".png")
            throw Error("A map of differences ends in .png; give -o such a name.");
        require_writable(options.output);
    }
    Pictures pictures(options);
    const Image reference = pictures.get(options.pictures.at(0));
    const Image test = pictures.get(options.pictures.at(1));
    if (reference.width != test.width || reference.height != test.height)
        throw Error(fmt::format("Pictures of {}x{} and of {}x{} cannot be compared; make them the same size.",
                                reference.width, reference.height, test.width, test.height));
    require_finite(reference, options.pictures.at(0));
    require_finite(test, options.pictures.at(1));
    const PixelRegion region = parse_region(options.region, reference);
    for (const MetricRow& row : metrics()) {
        if (only != nullptr && only != &row) continue;
        const std::vector<float> map = difference_map(reference, test, row.id);
        const double mean = mean_difference(part_of(map, reference.width, region), row.id);
        print(fmt::format("{:<32}{:.6g}\n", fmt::format("{} ({})", row.name, row.key), mean));
        if (options.output.empty()) continue;
        write_image(false_color(map, reference.width, reference.height, row.full_scale), options.output);
        print(fmt::format("map: black is 0, the brightest {:g} and more\n", row.full_scale));
    }
    if (const std::string note = note_on_alpha(reference, test); !note.empty()) print(note + "\n");
}

}  // namespace momentscope
