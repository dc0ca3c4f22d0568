#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/gl_context.hpp"
#include "app/needed_picture.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "core/error.hpp"
#include "core/inspect/moments_needed.hpp"
#include "core/json_text.hpp"
#include "core/output_file.hpp"
#include "core/render/renderer.hpp"

namespace momentscope {

namespace {

struct NeededMap {
    Image picture;  // by sorted fragments
    std::vector<PixelNeed> pixels;
};

NeededMap measure(const Options& options, const MomentOrders& orders, const ParameterValues& values) {
    const glm::ivec2 size = parse_size(options.size.empty() ? "320x180" : options.size);
    Progress progress("Moments needed");
    const Scene scene = load_scene_option(options, values, progress);
    const auto context = make_gl_context("osmesa", {16, 16});
    Renderer renderer;
    renderer.set_scene(scene);
    renderer.render({scene.camera, size, &require_technique("sorted"), values});
    NeededMap map = {renderer.read_picture(), {}};
    progress.show_stage("");
    for (int y = 0; y < size.y && !progress.stop().stop_requested(); ++y) {
        for (const PixelCapture& capture : renderer.capture_region({0, y}, {size.x, 1}))
            map.pixels.push_back(pixel_need(capture.ray, orders, values));
        progress.show(static_cast<std::size_t>(y + 1), static_cast<std::size_t>(size.y));
    }
    progress.require_finished();
    return map;
}

constexpr int TILE = 16;

nlohmann::ordered_json json_of(const NeedHistogram& histogram, double memory, const Options& options,
                               const ParameterValues& values) {
    nlohmann::ordered_json certificate, error;
    for (std::size_t i = 0; i < NEEDED_COUNT; ++i) {
        certificate[needed_text(static_cast<Needed>(i))] = histogram.by_certificate[i];
        error[needed_text(static_cast<Needed>(i))] = histogram.by_error[i];
    }
    return {{"scene", options.scene},
            {"basis", options.basis},
            {"tolerance", *values[ParameterId::tolerance]},
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
        "Moments so that T is certain within {:g} at every fragment, share of pixels\n{:<14}{:>16}{:>16}\n",
        *values[ParameterId::tolerance], "moments", "by certificate", "by error");
    for (std::size_t i = 0; i < NEEDED_COUNT; ++i)
        text += fmt::format("{:<14}{:>16}{:>16}\n", needed_text(static_cast<Needed>(i)),
                            percent(histogram.by_certificate[i]), percent(histogram.by_error[i]));
    text += fmt::format("The certificate asks for more than the error in {} of the pixels, for less in {}.\n",
                        percent(histogram.cautious), percent(histogram.overlooked));
    return text +
           fmt::format(
               "With moments as each tile of {0}x{0} pixels needs them, {1:.0f} % of the memory of eight.\n",
               TILE, 100 * memory);
}

}  // namespace

void run_needed(const Options& options) {
    const MomentOrders orders = moment_orders(options.basis);
    const ParameterValues values = parse_parameters(options);
    if (!options.format.empty() && options.format != "table" && options.format != "json")
        throw Error(fmt::format("'{}' is not a format; choose table or json.", options.format));
    const std::filesystem::path path = options.output;
    const std::string kind = path.extension().string();
    if (!path.empty() && kind != ".png" && kind != ".json")
        throw Error(fmt::format("'{}' is neither .png nor .json; give -o such a name.", path.string()));
    if (!path.empty()) require_writable(path);
    const NeededMap map = measure(options, orders, values);
    const NeedHistogram histogram = count_needs(map.pixels);
    const double memory = tiled_memory(map.pixels, map.picture.width, TILE);
    const std::string text = json_text(json_of(histogram, memory, options, values), 2) + "\n";
    if (kind == ".json") write_file(text, path);
    if (kind == ".png")
        write_needed_picture(
            map.picture, map.pixels,
            fmt::format("{}: the fewest {} moments so that T is certain within {:g} at every fragment",
                        options.scene, options.basis, *values[ParameterId::tolerance]),
            path);
    print(options.format == "json" ? text : table_of(histogram, memory, values));
}

}  // namespace momentscope
