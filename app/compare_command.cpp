#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "app/command.hpp"
#include "app/gl_context.hpp"
#include "app/ignored_options.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "core/compare/difference.hpp"
#include "core/compare/false_color.hpp"
#include "core/image/finite_pixels.hpp"
#include "core/render/renderer.hpp"
#include "core/support/error.hpp"
#include "core/support/memory.hpp"
#include "core/support/output_file.hpp"
#include "core/support/parse_number.hpp"

namespace momentscope {

namespace {

PixelRegion parse_region(const std::string& text, const Image& image) {
    if (text.empty()) return {0, 0, image.width, image.height};
    constexpr int MAX_COORDINATE = 99'999;  // pixels; sums of two must not overflow
    std::vector<int> numbers;
    for (const std::string& part : split_list({text})) {
        const auto number = parse_number<int>(part);
        if (number && *number >= 0 && *number <= MAX_COORDINATE) numbers.push_back(*number);
    }
    if (numbers.size() != 4 || split_list({text}).size() != 4)
        throw Error(
            fmt::format("'{}' is not a region; give x,y,width,height in pixels, such as 10,20,64,48.", text));
    const PixelRegion region = {numbers[0], numbers[1], numbers[2], numbers[3]};
    if (region.width < 1 || region.height < 1 || region.x + region.width > image.width ||
        region.y + region.height > image.height)
        throw Error(fmt::format("The region {} does not lie within pictures of {}x{}.", text, image.width,
                                image.height));
    return region;
}

/// Draws the scene with techniques; created when the first one is needed.
class DrawnPictures {
public:
    DrawnPictures(const std::string& scene, glm::ivec2 size, const ParameterValues& values,
                  Progress& progress)
        : size_(size),
          scene_(load_scene_and_warn(scene, values, progress)),
          context_(make_headless_context({16, 16})) {
        renderer_ = std::make_unique<Renderer>();
        renderer_->set_scene(scene_);
    }

    Image get(const Configuration& configuration) {
        renderer_->render({scene_.camera, size_, configuration.technique, configuration.values});
        return renderer_->read_picture();
    }

private:
    glm::ivec2 size_;
    Scene scene_;
    std::unique_ptr<GlContext> context_;
    std::unique_ptr<Renderer> renderer_;  // declared after the context that it needs
};

// A single NaN would make every metric NaN.
void require_finite(const Image& image, const std::string& name) {
    const std::string text = non_finite_text(image, fmt::format("'{}'", name));
    if (!text.empty()) throw Error(fmt::format("{}; such pictures cannot be compared.", text));
}

// A note about alpha, because the metrics compare only colours.
std::string note_on_alpha(const Image& reference, const Image& test) {
    float most = 0, least = 1;
    for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
        most = std::max(most, std::abs(reference.pixels[i].a - test.pixels[i].a));
        least = std::min({least, reference.pixels[i].a, test.pixels[i].a});
    }
    if (least >= 1 && most == 0) return "";
    return fmt::format(
        "alpha: colours are compared as stored, regardless of their alpha values, which differ by at most {:.6g}.",
        most);
}

// Checks the memory in advance. The numbers of bytes were measured, for the planes of FLIP and the maps of
// the other metrics.
void require_room(const Image& image, const MetricRow* only) {
    constexpr std::uintmax_t FLIP_BYTES = 224, OTHER_BYTES = 16;  // per pixel
    const bool flip = only == nullptr || only->id == Metric::flip;
    require_memory(image.pixels.size() * (flip ? FLIP_BYTES : OTHER_BYTES),
                   fmt::format("Comparing pictures of {}x{} by {}", image.width, image.height,
                               flip ? "FLIP" : only->name),
                   flip ? "make them smaller, or choose --metric rmse" : "make them smaller");
}

// The technique of a name that stands for a drawn picture; nullptr for a file.
const Technique* technique_named(const std::string& name) {
    return find_technique(name.substr(0, name.find(':')));
}

class Compare : public ParsedCommand {
public:
    explicit Compare(CLI::App& app) : ParsedCommand(app) {
        app.add_option(
               "pictures", pictures_,
               "reference and test: picture files, or techniques that draw the scene, such as at or at:nodes=8")
            ->required()
            ->expected(2);
        add_scene(app, scene_);
        add_size(app, size_);
        add_gl(app);
        add_parsed<const MetricRow*>(app, "--metric", metric_, "rmse, delta-e or flip [all]",
                                     [](const std::string& key) { return &require_metric(key); });
        app.add_option("--region", region_,
                       "x,y,width,height of the region to average over [the whole picture]");
        app.add_option("-o,--output", output_, "where to write a map of the metric as .png");
        parameters_.add_to(app);
    }

    void refuse_ignored() const override {
        std::vector<const Technique*> drawn;
        for (const std::string& name : pictures_)
            if (const Technique* technique = technique_named(name)) drawn.push_back(technique);
        const char* files = "when both pictures are files";
        refuse_ignored_options(app(), {{"--scene", drawn.empty(), files},
                                       {"--size", drawn.empty(), files},
                                       {"--gl", drawn.empty(), files}});
        refuse_ignored_parameters(parameters_, {.techniques = drawn,
                                                .picture = !drawn.empty(),
                                                .order = !drawn.empty(),
                                                .mesh = !drawn.empty() && has_mesh_file(scene_)});
    }

    FileUse files() const override {
        FileUse use = {scene_files(scene_), {{"-o", output_}}};
        use.inputs.insert(use.inputs.end(), pictures_.begin(), pictures_.end());
        return use;
    }

    void run() const override {
        if (!output_.empty()) {
            if (metric_ == nullptr)
                throw Error("A map shows a single metric; give --metric together with -o.");
            if (!ends_in(output_, ".png"))
                throw Error("A map of differences is a .png file; give -o such a name.");
            require_writable(output_);
        }
        std::string text;
        std::optional<Image> shown;  // the map of differences
        {
            Progress progress("Comparing");
            text = compared(progress, shown);
            progress.require_finished();
        }
        if (shown) write_image(*shown, output_);
        print(text);
    }

private:
    // Returns the text to print. If a map is requested, `map` is set to the differences of the one metric.
    std::string compared(Progress& progress, std::optional<Image>& map) const {
        std::optional<DrawnPictures> drawn;
        const Image reference = picture(pictures_.at(0), drawn, progress);
        const Image test = picture(pictures_.at(1), drawn, progress);
        if (reference.width != test.width || reference.height != test.height)
            throw Error(
                fmt::format("Pictures of {}x{} and of {}x{} cannot be compared; make them the same size.",
                            reference.width, reference.height, test.width, test.height));
        require_finite(reference, pictures_.at(0));
        require_finite(test, pictures_.at(1));
        const PixelRegion region = parse_region(region_, reference);
        require_room(reference, metric_);
        std::string text;
        for (const MetricRow& row : metrics()) {
            if (metric_ != nullptr && metric_ != &row) continue;
            const std::vector<float> differences = difference_map(reference, test, row.id, progress.stop());
            progress.require_finished();
            const double mean = mean_difference(part_of(differences, reference.width, region), row.id);
            text += fmt::format("{:<32}{:.6g}\n", fmt::format("{} ({})", row.name, row.key), mean);
            if (output_.empty()) continue;
            map = false_color(differences, reference.width, reference.height, row.full_scale);
            text += fmt::format("map: black is 0, the brightest colour is {:g} and more\n", row.full_scale);
        }
        if (const std::string note = note_on_alpha(reference, test); !note.empty()) text += note + "\n";
        return text;
    }

    Image picture(const std::string& name, std::optional<DrawnPictures>& drawn, Progress& progress) const {
        if (technique_named(name) == nullptr) return read_image(name);
        const ParameterValues values = parameters_.over();
        const Configuration configuration = parse_configuration(name, values);
        if (!drawn) drawn.emplace(scene_, size_, values, progress);
        return drawn->get(configuration);
    }

    std::vector<std::string> pictures_;
    std::string scene_ = STANDARD_SCENE;
    glm::ivec2 size_ = PICTURE_SIZE;
    const MetricRow* metric_ = nullptr;  // null: all
    std::string region_;
    std::string output_;
    ParameterOptions parameters_;
};

}  // namespace

std::unique_ptr<ParsedCommand> add_compare(CLI::App& app) {
    return std::make_unique<Compare>(app);
}

}  // namespace momentscope
