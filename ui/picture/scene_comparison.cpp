#include "ui/picture/scene_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "ui/model/comparison_map.hpp"
#include "ui/picture/pixel_lens.hpp"
#include "ui/widgets/technique_combo.hpp"

namespace momentscope::ui {

namespace {

float divider_x(const Rect& area, const CompareState& compare) {
    return area.low.x + compare.divider * (area.high.x - area.low.x);
}

// Name and id, or only the id, or nothing, depending on the space.
std::string label_within(const Technique& technique, float room) {
    for (const std::string& text : {technique_label(technique), std::string(technique.id)})
        if (ImGui::CalcTextSize(text.c_str()).x <= room) return text;
    return "";
}

}  // namespace

Rect divider_area(const Rect& area, const CompareState& compare) {
    const float x = divider_x(area, compare);
    return {{x - 0.4f * em(), area.low.y}, {x + 0.4f * em(), area.high.y}};
}

void draw_wipe(ImDrawList& list, const Rect& area, const ExplorerState& state, const Palette& colors) {
    const float x = divider_x(area, state.compare);
    list.AddRectFilled({x - 2, area.low.y}, {x + 2, area.high.y}, colors.mark_edge);
    list.AddRectFilled({x - 1, area.low.y}, {x + 1, area.high.y}, colors.mark);
    const ImVec2 knob = {x, 0.5f * (area.low.y + area.high.y)};
    const float radius = 0.75f * em();
    list.AddCircleFilled(knob, radius + 1.5f, colors.mark_edge);
    list.AddCircleFilled(knob, radius, colors.mark);
    for (const float way : {-1.0f, 1.0f}) {
        const float tip = knob.x + 0.55f * way * em();
        const float base = knob.x + 0.15f * way * em();
        list.AddTriangleFilled({tip, knob.y}, {base, knob.y + 0.3f * em()}, {base, knob.y - 0.3f * em()},
                               colors.mark_edge);
    }
    const Technique* left = state.compare.reference;
    const Technique* right = state.technique;
    if (state.compare.swapped) std::swap(left, right);
    const float pad = 0.8f * em();
    const std::string left_label = label_within(*left, x - area.low.x - 2 * pad);
    if (!left_label.empty()) draw_label(list, {area.low.x + pad, area.low.y + pad}, left_label, colors);
    const std::string right_label = label_within(*right, area.high.x - x - 2 * pad);
    const float width = ImGui::CalcTextSize(right_label.c_str()).x;
    if (!right_label.empty())
        draw_label(list, {area.high.x - pad - width, area.low.y + pad}, right_label, colors);
}

void draw_color_legend(ImDrawList& list, const Rect& area, const ColorLegend& legend, const Palette& colors) {
    const std::string title = fmt::format("{}{}", legend.name, legend.computing ? ": computing…" : "");
    const std::string range = fmt::format("least {:.3g}, greatest {:.3g}", legend.least, legend.most);
    const std::string end = fmt::format("{:.3g} and more", legend.end);
    const float line = ImGui::GetTextLineHeight();
    // Reserve space for text that comes and goes, so that the width stays the same.
    const float width =
        std::max({15 * em(), ImGui::CalcTextSize(range.c_str()).x,
                  ImGui::CalcTextSize((std::string(legend.name) + ": computing…").c_str()).x});
    const float pad = 0.8f * em();
    const ImVec2 low = {area.high.x - pad - width, area.low.y + pad};
    const float bar = 0.8f * em();
    const float height = 3 * line + bar + 0.5f * em();
    list.AddRectFilled({low.x - 0.4f * em(), low.y - 0.4f * em()},
                       {low.x + width + 0.4f * em(), low.y + height + 0.4f * em()},
                       (colors.plot_background & ~IM_COL32_A_MASK) | (230U << IM_COL32_A_SHIFT), 3);
    list.AddText(low, colors.text, title.c_str());
    const float top = low.y + line + 0.3f * em();
    const FalseColors& ramp = false_colors();
    for (std::size_t i = 0; i < ramp.size(); ++i) {
        const auto edge = [&](std::size_t n) {
            return low.x + width * static_cast<float>(n) / static_cast<float>(ramp.size());
        };
        list.AddRectFilled({edge(i), top}, {edge(i + 1), top + bar},
                           IM_COL32(ramp[i][0], ramp[i][1], ramp[i][2], 255));
    }
    list.AddRect({low.x, top}, {low.x + width, top + bar}, colors.axis);
    const float ticks = top + bar + 0.1f * em();
    list.AddText({low.x, ticks}, colors.text, "0");
    list.AddText({low.x + width - ImGui::CalcTextSize(end.c_str()).x, ticks}, colors.text, end.c_str());
    list.AddText({low.x, ticks + line}, colors.text, range.c_str());
}

void draw_region(ImDrawList& list, const Rect& area, const PictureRegion& region, const Palette& colors) {
    const ImVec2 size = {area.high.x - area.low.x, area.high.y - area.low.y};
    const ImVec2 low = {area.low.x + region.low.x * size.x, area.low.y + region.low.y * size.y};
    const ImVec2 high = {area.low.x + region.high.x * size.x, area.low.y + region.high.y * size.y};
    list.AddRect({low.x - 1, low.y - 1}, {high.x + 1, high.y + 1}, colors.mark_edge, 0, 0, 4);
    list.AddRect({low.x - 1, low.y - 1}, {high.x + 1, high.y + 1}, colors.mark, 0, 0, 2);
}

}  // namespace momentscope::ui
