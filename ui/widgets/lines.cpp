#include "ui/widgets/lines.hpp"

#include <algorithm>
#include <cmath>

#include "ui/widgets/ui.hpp"

namespace momentscope::ui {

void draw_line(ImDrawList& list, const std::vector<ImVec2>& points, ImU32 tint, float thickness) {
    // Draw pieces that share a point, because ImGui numbers the vertices of one call with 16 bits.
    constexpr std::size_t PIECE = 4000;
    for (std::size_t first = 0; first + 1 < points.size(); first += PIECE - 1)
        list.AddPolyline(&points[first], static_cast<int>(std::min(PIECE, points.size() - first)), tint,
                         ImDrawFlags_None, thickness);
}

void draw_dashed(ImDrawList& list, const std::vector<ImVec2>& points, ImU32 tint, float thickness,
                 ImVec2 dash) {
    if (!(dash.x > 0)) return draw_line(list, points, tint, thickness);
    const float scale = em() / 15;
    const float on = dash.x * scale;
    const float period = (dash.x + dash.y) * scale;
    float along = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const ImVec2 a = points[i - 1];
        const ImVec2 step = {points[i].x - a.x, points[i].y - a.y};
        const float length = std::sqrt(step.x * step.x + step.y * step.y);
        if (!(length > 0) || !(length < 1e5f)) continue;
        for (float begin = 0; begin < length;) {
            const float phase = std::fmod(along + begin, period);
            const float rest = (phase < on ? on : period) - phase;
            const float end = std::min(begin + std::max(rest, 0.05f), length);
            if (phase < on)
                list.AddLine({a.x + step.x * begin / length, a.y + step.y * begin / length},
                             {a.x + step.x * end / length, a.y + step.y * end / length}, tint, thickness);
            begin = end;
        }
        along += length;
    }
}

}  // namespace momentscope::ui
