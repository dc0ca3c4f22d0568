#include "ui/picture/pixel_lens.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace momentscope::ui {

namespace {

struct Level {
    int radius;
    float cell;  // in font heights
};
constexpr Level LEVELS[] = {{15, 0.5f}, {7, 1.0f}, {2, 3.0f}, {2, 5.2f}};

const Level& level_of(LensZoom zoom) {
    return LEVELS[static_cast<std::size_t>(zoom)];
}

float width_of(const std::string& text, float size) {
    return ImGui::GetFont()->CalcTextSizeA(size, 1e6f, 0, text.c_str()).x;
}

// The largest text size, up to the usual one, at which every value fits into its pixel; 0 if it would not be
// readable.
float value_size(const Lens& lens, float cell) {
    float size = std::min(0.9f * em(), 0.27f * cell);
    for (const LensPixel& pixel : lens.pixels)
        for (const std::string& value : pixel.values) {
            const float width = width_of(value, size);
            if (width > 0.9f * cell) size *= 0.9f * cell / width;
        }
    return size < 0.6f * em() ? 0 : size;
}

void draw_pixel(ImDrawList& list, const LensPixel& pixel, ImVec2 at, float cell, float size) {
    const auto& [r, g, b] = pixel.color;
    list.AddRectFilled(at, {at.x + cell, at.y + cell}, IM_COL32(r, g, b, 255));
    if (size <= 0) return;
    const bool bright = 2 * r + 5 * g + b > 8 * 110;
    const float line = 1.08f * size;
    const auto count = static_cast<float>(
        std::ranges::count_if(pixel.values, [](const std::string& value) { return !value.empty(); }));
    float y = at.y + 0.5f * (cell - count * line);
    for (const std::string& value : pixel.values) {
        if (value.empty()) continue;
        list.AddText(ImGui::GetFont(), size, {at.x + 0.5f * (cell - width_of(value, size)), y},
                     bright ? IM_COL32(0, 0, 0, 255) : IM_COL32(255, 255, 255, 255), value.c_str());
        y += line;
    }
}

}  // namespace

int lens_radius(LensZoom zoom) {
    return level_of(zoom).radius;
}

void draw_label(ImDrawList& list, ImVec2 at, const std::string& text, const Palette& colors) {
    const ImVec2 extent = ImGui::CalcTextSize(text.c_str());
    const float pad = 0.4f * em();
    list.AddRectFilled({at.x - pad, at.y - pad}, {at.x + extent.x + pad, at.y + extent.y + pad},
                       (colors.plot_background & ~IM_COL32_A_MASK) | (215U << IM_COL32_A_SHIFT), 3);
    list.AddText(at, colors.text, text.c_str());
}

float draw_lens(ImDrawList& list, const Rect& area, const Lens& lens, LensZoom zoom, glm::ivec2 pixel,
                const Palette& colors) {
    if (lens.extent.x < 1) return 0;
    const float pad = 0.5f * em();
    const float heading = 2.2f * em();
    const auto most = static_cast<float>(2 * lens_radius(zoom) + 1);
    const ImVec2 room = {area.high.x - area.low.x - 2 * pad, area.high.y - area.low.y - 2 * pad - heading};
    const float cell = std::min({level_of(zoom).cell * em(), room.x / most, room.y / most});
    if (cell < 2) return 0;
    const ImVec2 extent = {cell * static_cast<float>(lens.extent.x),
                           cell * static_cast<float>(lens.extent.y)};
    ImVec2 low = {area.low.x + pad, area.high.y - pad - extent.y};
    const ImVec2 at = {area.low.x + static_cast<float>(pixel.x), area.low.y + static_cast<float>(pixel.y)};
    const bool hides_pixel = at.x < low.x + extent.x + em() && at.y > low.y - heading - em();
    const float right = area.high.x - pad - extent.x;
    const bool on_right = hides_pixel && at.x < right - em();
    if (on_right) low.x = right;
    list.AddRectFilled({low.x - 3, low.y - 3}, {low.x + extent.x + 3, low.y + extent.y + 3},
                       colors.mark_edge);
    const float size = value_size(lens, cell);
    for (int y = 0; y < lens.extent.y; ++y)
        for (int x = 0; x < lens.extent.x; ++x)
            draw_pixel(list, lens.pixels[static_cast<std::size_t>(y * lens.extent.x + x)],
                       {low.x + cell * static_cast<float>(x), low.y + cell * static_cast<float>(y)}, cell,
                       size);
    const glm::vec2 middle = glm::vec2(pixel - lens.corner) * cell;
    const ImVec2 frame = {low.x + middle.x, low.y + middle.y};
    list.AddRect(frame, {frame.x + cell, frame.y + cell}, colors.mark_edge, 0, 0, 4);
    list.AddRect(frame, {frame.x + cell, frame.y + cell}, colors.mark, 0, 0, 2);
    const std::string values = lens.values.empty() || size <= 0 ? "" : ": " + lens.values;
    draw_label(list, {low.x + pad, low.y - 1.6f * em()},
               fmt::format("pixel {}, {}{}", pixel.x, pixel.y, values), colors);
    return on_right ? 0 : extent.y + heading;
}

}  // namespace momentscope::ui
