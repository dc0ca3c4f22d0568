#include "ui/picture/lens_content.hpp"

#include <fmt/format.h>

#include <cmath>

namespace momentscope::ui {

namespace {

LensPixel picture_pixel(const glm::vec4& linear, LensZoom zoom) {
    LensPixel pixel;
    for (std::size_t c = 0; c < 3; ++c) {
        const float value = linear[static_cast<int>(c)];
        pixel.color[c] = static_cast<unsigned char>(std::lround(255 * srgb_from_linear(value)));
        if (zoom == LensZoom::values)
            pixel.values[c] = fmt::format("{}", pixel.color[c]);
        else if (zoom == LensZoom::digits)
            pixel.values[c] = fmt::format("{} {:.4f}", "RGB"[c], value);
    }
    return pixel;
}

bool writes_values(LensZoom zoom) {
    return zoom == LensZoom::values || zoom == LensZoom::digits;
}

// A pixel of a map: its colour, and the differences or the number behind it.
LensPixel map_pixel(const Comparison& comparison, LensZoom zoom, glm::ivec2 at) {
    const ComparisonMap& map = comparison.map();
    const auto index = static_cast<std::size_t>(at.y * map.size.x + at.x);
    LensPixel pixel;
    for (std::size_t c = 0; c < 3; ++c) pixel.color[c] = map.rgba[4 * index + c];
    if (!writes_values(zoom)) return pixel;
    if (map.mode != CompareMode::difference) {
        pixel.values[0] = fmt::format("{:.3g}", map.numbers[index]);
        return pixel;
    }
    const PicturePair& pair = comparison.pair();
    for (std::size_t c = 0; c < 3; ++c) {
        const int channel = static_cast<int>(c);
        const float difference = pair.picture.pixels[index][channel] - pair.reference.pixels[index][channel];
        pixel.values[c] = zoom == LensZoom::digits ? fmt::format("{} {:+.4f}", "RGB"[c], difference)
                                                   : fmt::format("{:+.2f}", difference);
    }
    return pixel;
}

// Is the pixel on the reference's side of the wipe?
bool on_reference_side(const CompareState& compare, int x, int width) {
    const float divider = compare.divider * static_cast<float>(width);
    return (static_cast<float>(x) + 0.5f < divider) != compare.swapped;
}

std::string values_text(const Comparison& comparison, LensZoom zoom, bool map) {
    if (!writes_values(zoom)) return "";
    if (!map) return zoom == LensZoom::values ? "sRGB" : "linear";
    if (comparison.map().mode == CompareMode::difference) return "picture - reference";
    if (comparison.map().mode == CompareMode::uncertainty) return "left open";
    return metrics()[static_cast<std::size_t>(comparison.map().metric)].symbol;
}

}  // namespace

void update_lens(Lens& lens, const Update& update, const Renderer& renderer,
                 const PictureComparison& comparison, const LensInput& input) {
    const ExplorerState& state = update.state;
    const LensZoom zoom = state.lens_zoom;
    const bool flipped = comparison.flipped();
    if (!state.lens) lens = {};
    const bool stale = input.changed || lens.flipped != flipped || lens.extent.x == 0 ||
                       update.shown.compare != state.compare || update.shown.lens_zoom != zoom;
    lens.flipped = flipped;
    if (!state.lens || !stale) return;
    const int radius = lens_radius(zoom);
    lens.corner = glm::max(input.middle - radius, glm::ivec2(0));
    lens.extent = glm::min(input.middle + radius + 1, input.size) - lens.corner;
    lens.pixels.clear();
    const bool map = input.map && comparison.numbers().map().size == input.size;
    const bool wipe = !flipped && has_comparison(state) && state.compare.mode == CompareMode::wipe;
    const bool only_reference = flipped && has_comparison(state);
    Image own, reference;
    if (!map && !only_reference) own = renderer.read_region(lens.corner, lens.extent);
    if (wipe || only_reference) reference = comparison.reference().region(lens.corner, lens.extent);
    for (int y = 0; y < lens.extent.y; ++y)
        for (int x = 0; x < lens.extent.x; ++x) {
            const glm::ivec2 at = lens.corner + glm::ivec2(x, y);
            const bool other =
                only_reference || (wipe && on_reference_side(state.compare, at.x, input.size.x));
            lens.pixels.push_back(map ? map_pixel(comparison.numbers(), zoom, at)
                                      : picture_pixel((other ? reference : own).at(x, y), zoom));
        }
    lens.values = values_text(comparison.numbers(), zoom, map);
}

}  // namespace momentscope::ui
