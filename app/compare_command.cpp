#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "app/commands.hpp"
#include "app/gl_context.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "core/compare/difference.hpp"
#include "core/compare/false_color.hpp"
#include "core/error.hpp"
#include "core/image/finite_pixels.hpp"
#include "core/memory.hpp"
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
        throw Error(
            fmt::format("'{}' is not a region; give x,y,width,height in pixels, as 10,20,64,48.", text));
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
    Pictures(const Options& options, Progress& progress)
        : options_(options), progress_(progress), parameters_(parse_parameters(options)) {}

    Image get(const std::string& name) {
        if (find_technique(name.substr(0, name.find(':'))) == nullptr) return read_image(name);
        const Configuration configuration = parse_configuration(name, parameters_);
        if (renderer_ == nullptr) {
            scene_ = load_scene_option(options_, parameters_, progress_);
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
    Progress& progress_;
    ParameterValues parameters_;
    Scene scene_;
    std::unique_ptr<GlContext> context_;
    std::unique_ptr<Renderer> renderer_;  // after the context that it needs
};

// A single NaN would make every metric NaN.
void require_finite(const Image& image, const std::string& name) {
    const std::string text = non_finite_text(image, fmt::format("'{}'", name));
    if (!text.empty()) throw Error(fmt::format("{}; such pictures cannot be compared.", text));
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

// Before it is taken. Measured: what the planes of FLIP take, and the maps of the others.
void require_room(const Image& image, const MetricRow* only) {
    constexpr std::uintmax_t FLIP_BYTES = 224, OTHER_BYTES = 16;  // of a pixel
    const bool flip = only == nullptr || only->id == Metric::flip;
    require_memory(image.pixels.size() * (flip ? FLIP_BYTES : OTHER_BYTES),
                   fmt::format("Comparing pictures of {}x{} by {}", image.width, image.height,
                               flip ? "FLIP" : only->name),
                   flip ? "make them smaller, or choose --metric rmse" : "make them smaller");
}

// What is to be said of them; `map` shows the differences of the one metric, where it is wanted.
std::string compared(const Options& options, const MetricRow* only, Progress& progress,
                     std::optional<Image>& map) {
    Pictures pictures(options, progress);
    const Image reference = pictures.get(options.pictures.at(0));
    const Image test = pictures.get(options.pictures.at(1));
    if (reference.width != test.width || reference.height != test.height)
        throw Error(fmt::format("Pictures of {}x{} and of {}x{} cannot be compared; make them the same size.",
                                reference.width, reference.height, test.width, test.height));
    require_finite(reference, options.pictures.at(0));
    require_finite(test, options.pictures.at(1));
    const PixelRegion region = parse_region(options.region, reference);
    require_room(reference, only);
    std::string text;
    for (const MetricRow& row : metrics()) {
        if (only != nullptr && only != &row) continue;
        const std::vector<float> differences = difference_map(reference, test, row.id, progress.stop());
        progress.require_finished();
        const double mean = mean_difference(part_of(differences, reference.width, region), row.id);
        text += fmt::format("{:<32}{:.6g}\n", fmt::format("{} ({})", row.name, row.key), mean);
        if (options.output.empty()) continue;
        map = false_color(differences, reference.width, reference.height, row.full_scale);
        text += fmt::format("map: black is 0, the brightest {:g} and more\n", row.full_scale);
    }
    if (const std::string note = note_on_alpha(reference, test); !note.empty()) text += note + "\n";
    return text;
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
    std::string text;
    std::optional<Image> shown;  // of the differences
    {
        Progress progress("Comparing");
        text = compared(options, only, progress, shown);
        progress.require_finished();
    }
    if (shown) write_image(*shown, options.output);
    print(text);
}

}  // namespace momentscope
