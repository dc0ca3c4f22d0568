#include "ui/plot/plot_legend.hpp"

#include <fmt/format.h>

#include "ui/plot/plot_layers.hpp"
#include "ui/plot/series_color.hpp"

namespace momentscope::ui {

namespace {

// A legend entry that can be clicked: a swatch and a name. It goes to the next line if this one is full.
bool legend_entry(const Ui& ui, const char* name, ImU32 tint, ImVec2 dash, bool on, float right, bool first,
                  const std::string& anchor) {
    const float swatch = 1.5f * em();
    const ImVec2 size = {swatch + 0.4f * em() + ImGui::CalcTextSize(name).x, ImGui::GetTextLineHeight() + 2};
    if (!first) flow(size.x, right, 0.9f * em());
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool clicked = ImGui::InvisibleButton(name, size);
    ui.record_widget_rect(anchor);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 text = on ? ImGui::GetColorU32(ImGuiCol_Text) : ImGui::GetColorU32(ImGuiCol_TextDisabled);
    const float y = at.y + 0.5f * size.y;
    draw_dashed(list, {{at.x, y}, {at.x + swatch, y}}, on ? tint : text, on ? em() / 5 : 1, dash);
    list.AddText({at.x + swatch + 0.4f * em(), at.y + 1}, text, name);
    if (!on)  // struck through, so that the meaning does not depend on grey alone
        list.AddLine({at.x + swatch + 0.4f * em(), y + 1}, {at.x + size.x, y + 1}, text);
    return clicked;
}

}  // namespace

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
