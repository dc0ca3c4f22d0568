// explorer_lens.cpp -- the content of the lens: the visible pixels and their values.
#include <fmt/format.h>

#include <cmath>

#include "ui/explorer.hpp"

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

}  // namespace

// A pixel of a map: its colour, and the differences or the number behind it.
LensPixel Explorer::map_pixel(glm::ivec2 at) const {
    const ComparisonMap& map = comparison_.map();
    const auto index = static_cast<std::size_t>(at.y * comparison_.size().x + at.x);
    LensPixel pixel;
    for (std::size_t c = 0; c < 3; ++c) pixel.color[c] = map.rgba[4 * index + c];
    if (!writes_values(state_.lens_zoom)) return pixel;
    if (map.mode == CompareMode::false_color) {
        pixel.values[0] = fmt::format("{:.3g}", comparison_.result(map.metric)->map[index]);
        return pixel;
    }
    const PicturePair& pair = comparison_.pair();
    for (std::size_t c = 0; c < 3; ++c) {
        const int channel = static_cast<int>(c);
        const float difference = pair.picture.pixels[index][channel] - pair.reference.pixels[index][channel];
        pixel.values[c] = state_.lens_zoom == LensZoom::digits
                              ? fmt::format("{} {:+.4f}", "RGB"[c], difference)
                              : fmt::format("{:+.2f}", difference);
    }
    return pixel;
}

// Is the pixel on the reference's side of the wipe?
bool Explorer::on_reference_side(int x, int width) const {
    const float divider = state_.compare.divider * static_cast<float>(width);
    return (static_cast<float>(x) + 0.5f < divider) != state_.compare.swapped;
}

// Reads pixels back only if the lens shows other ones.
void Explorer::update_lens(glm::ivec2 size, bool stale) {
    Lens& lens = picture_.lens;
    if (!state_.lens) lens = {};
    stale |= lens_flipped_ != flipped_ || lens.extent.x == 0 || shown_state_.compare != state_.compare ||
             shown_state_.lens_zoom != state_.lens_zoom;
    lens_flipped_ = flipped_;
    if (!state_.lens || !stale) return;
    const int radius = lens_radius(state_.lens_zoom);
    lens.corner = glm::max(measurement_.pixel - radius, glm::ivec2(0));
    lens.extent = glm::min(measurement_.pixel + radius + 1, size) - lens.corner;
    lens.pixels.clear();
    const bool map = !flipped_ && picture_.beside == 0 && picture_.texture == comparison_.map().texture &&
                     comparison_.size() == size;
    const bool wipe = picture_.beside != 0;
    const bool only_reference = flipped_ && has_comparison();
    Image own, reference;
    if (!map && !only_reference) own = renderer_.read_region(lens.corner, lens.extent);
    if (!map && (wipe || only_reference)) reference = reference_->read_region(lens.corner, lens.extent);
    for (int y = 0; y < lens.extent.y; ++y)
        for (int x = 0; x < lens.extent.x; ++x) {
            const glm::ivec2 at = lens.corner + glm::ivec2(x, y);
            const bool other = only_reference || (wipe && on_reference_side(at.x, size.x));
            lens.pixels.push_back(map ? map_pixel(at)
                                      : picture_pixel((other ? reference : own).at(x, y), state_.lens_zoom));
        }
    if (!writes_values(state_.lens_zoom))
        lens.values.clear();
    else if (!map)
        lens.values = state_.lens_zoom == LensZoom::values ? "sRGB" : "linear";
    else if (comparison_.map().mode == CompareMode::difference)
        lens.values = "picture - reference";
    else
        lens.values = metrics()[static_cast<std::size_t>(comparison_.map().metric)].symbol;
}

}  // namespace momentscope::ui
