#include "ui/plot/plot_legend.hpp"

#include <fmt/format.h>

#include <vector>

#include "ui/plot/plot_layers.hpp"
#include "ui/plot/series_color.hpp"

namespace momentscope::ui {

namespace {

constexpr float SWATCH = 1.5f, BESIDE_SWATCH = 0.4f, BETWEEN = 0.9f;  // in em

ImVec2 entry_size(const char* name) {
    return {(SWATCH + BESIDE_SWATCH) * em() + ImGui::CalcTextSize(name).x, ImGui::GetTextLineHeight() + 2};
}

// A legend entry that can be clicked: a swatch and a name. It goes to the next line if this one is full.
bool legend_entry(const Ui& ui, const char* name, ImU32 tint, ImVec2 dash, bool on, float right, bool first,
                  const std::string& anchor) {
    const float swatch = SWATCH * em();
    const ImVec2 size = entry_size(name);
    if (!first) flow(size.x, right, BETWEEN * em());
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool clicked = ImGui::InvisibleButton(name, size);
    ui.record_widget_rect(anchor);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 text = on ? ImGui::GetColorU32(ImGuiCol_Text) : ImGui::GetColorU32(ImGuiCol_TextDisabled);
    const float y = at.y + 0.5f * size.y;
    draw_dashed(list, {{at.x, y}, {at.x + swatch, y}}, on ? tint : text, on ? em() / 5 : 1, dash);
    list.AddText({at.x + swatch + BESIDE_SWATCH * em(), at.y + 1}, text, name);
    if (!on)  // struck through, so that the meaning does not depend on grey alone
        list.AddLine({at.x + swatch + BESIDE_SWATCH * em(), y + 1}, {at.x + size.x, y + 1}, text);
    return clicked;
}

}  // namespace

float legend_height(const Measurement& m, float width) {
    std::vector<const char*> names;
    for (const SeriesRow& row : series_rows())
        if (has_series(row.id, *m.curve.technique)) names.push_back(series_name(row, *m.curve.technique));
    for (const Curve& compared : m.compared) names.push_back(compared.technique->id);
    float lines = 1, right = 0;
    for (const char* name : names) {
        const float entry = entry_size(name).x;
        const float begin = right > 0 ? right + BETWEEN * em() : 0;
        lines += right > 0 && begin + entry > width ? 1 : 0;
        right = right > 0 && begin + entry > width ? entry : begin + entry;
    }
    return lines * (ImGui::GetTextLineHeight() + 2 + ImGui::GetStyle().ItemSpacing.y);
}

std::optional<Series> draw_legend(const Ui& ui, const Measurement& m, ExplorerState& state, float right) {
    std::optional<Series> hovered;
    const Technique& technique = *m.curve.technique;
    bool first = true;
    for (const SeriesRow& row : series_rows()) {
        if (!has_series(row.id, technique)) continue;
        bool& shown = state.plot.shown[static_cast<std::size_t>(row.id)];
        const ImVec2 dash = row.id == Series::unbiased_exact ? UNBIASED_EXACT_DASH
                            : row.id == Series::sharp        ? SHARP_DASH
                                                             : ImVec2(0, 0);
        if (legend_entry(ui, series_name(row, technique), series_color(row.id, ui.colors), dash, shown, right,
                         first, fmt::format("legend.{}", row.key)))
            shown = !shown;
        if (ImGui::IsItemHovered() && shown) hovered = row.id;
        tooltip(series_help(row, technique), fmt::format("{}, or click to show or hide", row.shortcut));
        first = false;
    }
    for (std::size_t i = 0; i < m.compared.size(); ++i) {
        const Technique* compared = m.compared[i].technique;
        if (legend_entry(ui, compared->id, ui.colors.compared[i % ui.colors.compared.size()], dash_of(i),
                         true, right, first, fmt::format("legend.{}", compared->id)))
            std::erase(state.compared, compared);
        tooltip(compared->description, "click to remove it from the plot");
        first = false;
    }
    return hovered;
}

}  // namespace momentscope::ui
