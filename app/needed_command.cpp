#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/command.hpp"
#include "app/gl_context.hpp"
#include "app/ignored_options.hpp"
#include "app/needed_picture.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "core/compare/false_color.hpp"
#include "core/inspect/color_uncertainty.hpp"
#include "core/inspect/moments_needed.hpp"
#include "core/render/renderer.hpp"
#include "core/support/error.hpp"
#include "core/support/json_text.hpp"
#include "core/support/output_file.hpp"

namespace momentscope {

namespace {

struct NeededMap {
    Image picture;  // drawn with `sorted`
    std::vector<PixelNeed> pixels;
};

constexpr int TILE = 16;

Configuration configuration_with_moments(const std::string& text) {
    const Configuration configuration = parse_configuration(text);
    if (!configuration.technique->has_moments())
        throw Error(
            fmt::format("'{}' has no moments, so it has no bounds; choose a technique with moments.", text));
    return configuration;
}

nlohmann::ordered_json json_of(const NeedHistogram& histogram, double memory, const std::string& scene,
                               const std::string& basis, const ParameterValues& values) {
    nlohmann::ordered_json certificate, error;
    for (std::size_t i = 0; i < NEEDED_COUNT; ++i) {
        certificate[needed_text(static_cast<Needed>(i))] = histogram.by_certificate[i];
        error[needed_text(static_cast<Needed>(i))] = histogram.by_error[i];
    }
    return {{"scene", scene},
            {"basis", basis},
            {"tolerance", values.number(ParameterId::tolerance)},
            {"pixels_by_certificate", certificate},
            {"pixels_by_error", error},
            {"certificate_asks_for_more", histogram.cautious},
            {"error_asks_for_more", histogram.overlooked},
            {"tile", TILE},
            {"tiled_memory", memory}};
}

std::string table_of(const NeedHistogram& histogram, double memory, const ParameterValues& values) {
    long all = 0;
    for (const long count : histogram.by_error) all += count;
    const auto percent = [&](long count) {
        return fmt::format("{:.1f} %", 100.0 * static_cast<double>(count) / static_cast<double>(all));
    };
    std::string text = fmt::format(
        "Moments that make T certain within {:g} at every fragment: share of pixels\n{:<14}{:>16}{:>16}\n",
        values.number(ParameterId::tolerance), "moments", "by certificate", "by error");
    for (std::size_t i = 0; i < NEEDED_COUNT; ++i)
        text += fmt::format("{:<14}{:>16}{:>16}\n", needed_text(static_cast<Needed>(i)),
                            percent(histogram.by_certificate[i]), percent(histogram.by_error[i]));
    text += fmt::format(
        "The certificate asks for more moments than the error in {} of the pixels, and for fewer in {}.\n",
        percent(histogram.cautious), percent(histogram.overlooked));
    return text +
           fmt::format(
               "If each tile of {0}x{0} pixels stores the moments that it needs, this takes {1:.0f} % of the memory of eight.\n",
               TILE, 100 * memory);
}

class NeededCommand : public ParsedCommand {
public:
    explicit NeededCommand(CLI::App& app) : ParsedCommand(app) {
        add_scene(app, scene_);
        add_size(app, size_);
        add_gl(app);
        app.add_option("--basis", basis_, "power or chebyshev")->capture_default_str();
        add_parsed<bool>(app, "--format", json_, "table or json [table]", [](const std::string& text) {
            if (text != "table" && text != "json")
                throw Error(fmt::format("'{}' is not a format; choose table or json.", text));
            return text == "json";
        });
        add_parsed<Configuration>(
            app, "--uncertainty", of_technique_,
            "a technique with moments, such as sharp4: instead, how much of each pixel's "
            "luminance its bounds leave open, beside the error",
            [](const std::string& text) { return configuration_with_moments(text); });
        app.add_option("-o,--output", output_, ".png (maps) or .json");
        parameters_.add_to(app);
    }

    void refuse_ignored() const override {
        const bool uncertainty = of_technique_.technique != nullptr;
        const char* of_it = "with --uncertainty; write the parameters of the technique after its id";
        refuse_ignored_options(app(), {{"--basis", uncertainty, of_it}, {"--format", uncertainty, of_it}});
        std::vector<ParameterId> others;
        if (!uncertainty)
            others = {ParameterId::tolerance, ParameterId::estimate, ParameterId::ends,
                      ParameterId::interval};
        refuse_ignored_parameters(parameters_, {.techniques = {},
                                                .others = others,
                                                .picture = ends_in(output_, ".png"),
                                                .mesh = has_mesh_file(scene_)});
    }

    FileUse files() const override { return {scene_files(scene_), {{"-o", output_}}}; }

    void run() const override {
        const MomentOrders orders = moment_orders(basis_);
        const ParameterValues values = parameters_.over();
        refuse_nonsense(orders, values);
        const bool png = ends_in(output_, ".png");
        if (!output_.empty() && !png && !ends_in(output_, ".json"))
            throw Error(fmt::format("'{}' ends in neither .png nor .json; give -o such a name.", output_));
        if (!output_.empty()) require_writable(output_);
        if (of_technique_.technique != nullptr) return run_uncertainty(values);
        const NeededMap map = measure(orders, values);
        const NeedHistogram histogram = count_needs(map.pixels);
        const double memory = tiled_memory(map.pixels, map.picture.width, TILE);
        const std::string text = json_text(json_of(histogram, memory, scene_, basis_, values), 2) + "\n";
        if (png)
            write_needed_picture(
                map.picture, map.pixels,
                fmt::format("{}: the fewest {} moments that make T certain within {:g} at every fragment",
                            scene_, basis_, values.number(ParameterId::tolerance)),
                output_);
        else if (!output_.empty())
            write_file(text, output_);
        print(json_ ? text : table_of(histogram, memory, values));
    }

private:
    // Two maps in one picture: what the bounds leave open on the left, the error on the right.
    void run_uncertainty(const ParameterValues& values) const {
        if (ends_in(output_, ".json"))
            throw Error("The uncertainty is drawn as a .png; give -o such a name.");
        std::vector<ColorUncertainty> pixels;
        capture_rows(values, [&](const PixelCapture& capture) {
            pixels.push_back(color_uncertainty(capture, of_technique_));
        });
        std::string text =
            fmt::format("{}, {}\n{}", scene_, configuration_text(of_technique_), uncertainty_text(pixels));
        if (!output_.empty()) {
            constexpr float OPEN_SCALE = OPEN_FULL_SCALE / 4, ERROR_SCALE = OPEN_FULL_SCALE / 40;
            std::vector<float> values_of_both(2 * pixels.size());
            for (int y = 0; y < size_.y; ++y)
                for (int x = 0; x < size_.x; ++x) {
                    const ColorUncertainty& pixel = pixels[static_cast<std::size_t>(y * size_.x + x)];
                    const auto row = static_cast<std::size_t>(2 * y * size_.x + x);
                    values_of_both[row] = pixel.open / OPEN_SCALE;
                    values_of_both[row + static_cast<std::size_t>(size_.x)] = pixel.error / ERROR_SCALE;
                }
            write_image(false_color(values_of_both, 2 * size_.x, size_.y, 1), output_);
            text += fmt::format(
                "maps: left what is open, right the error; the brightest colours are {:g} and {:g} and more\n",
                OPEN_SCALE, ERROR_SCALE);
        }
        print(text);
    }

    NeededMap measure(const MomentOrders& orders, const ParameterValues& values) const {
        NeededMap map;
        map.picture = capture_rows(values, [&](const PixelCapture& capture) {
            map.pixels.push_back(pixel_need(capture.ray, orders, values));
        });
        return map;
    }

    // Draws the scene with `sorted`, and hands over every pixel, row by row from the upper left.
    template <typename Use>
    Image capture_rows(const ParameterValues& values, const Use& use) const {
        Progress progress("Moments needed");
        const Scene scene = load_scene_and_warn(scene_, values, progress);
        const auto context = make_headless_context({16, 16});
        Renderer renderer;
        renderer.set_scene(scene);
        renderer.render({scene.camera, size_, &require_technique("sorted"), values});
        Image picture = renderer.read_picture();
        progress.show_stage("");
        for (int y = 0; y < size_.y && !progress.stop().stop_requested(); ++y) {
            for (const PixelCapture& capture : renderer.capture_region({0, y}, {size_.x, 1})) use(capture);
            progress.show(static_cast<std::size_t>(y + 1), static_cast<std::size_t>(size_.y));
        }
        progress.require_finished();
        return picture;
    }

    std::string scene_ = STANDARD_SCENE;
    glm::ivec2 size_ = {320, 180};
    std::string basis_ = "power";
    bool json_ = false;  // whether to print JSON instead of a table
    Configuration of_technique_;
    std::string output_;
    ParameterOptions parameters_;
};

}  // namespace

std::unique_ptr<ParsedCommand> add_needed(CLI::App& app) {
    return std::make_unique<NeededCommand>(app);
}

}  // namespace momentscope
