#include "ui/plot/pinned_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "ui/model/selection.hpp"
#include "ui/plot/plot_layers.hpp"

namespace momentscope::ui {

namespace {

void draw_small_plot(const Ui& ui, const Pinned& pin, std::size_t number, PlotState plot, const Rect& area) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float line = ImGui::GetTextLineHeight();
    list.PushClipRect(area.low, area.high, true);
    list.AddRectFilled(area.low, area.high, ui.colors.plot_background, 3);
    fit(plot);
    const Rect inner = {{area.low.x, area.low.y + 1.2f * line}, {area.high.x, area.high.y - 2}};
    const PlotAxes axes = make_axes(pin.ray, pin.curve, plot, inner, false);
    draw_small_layers(list, axes, ui.colors, pin.ray, pin.curve);
    draw_text(list, {area.low.x + 5, area.low.y + 1}, {0, 0},
              fmt::format("{}: pixel {}, {}", number, pin.pixel.x, pin.pixel.y), ui.colors.text);
    draw_text(list, {area.high.x - 0.65f * line, area.low.y + 0.6f * line}, {0.5f, 0.5f}, "×",
              ui.colors.text);
    list.PopClipRect();
}

}  // namespace

void draw_pinned_plots(const Ui& ui, const Measurement& m, ExplorerState& state, ImVec2 size) {
    if (m.pins.empty()) return;
    const float gap = 0.4f * em();
    const float cross = 1.3f * ImGui::GetTextLineHeight();  // side of the square that removes the pin
    const auto count = static_cast<float>(m.pins.size());
    const ImVec2 each = {std::max((size.x - gap * (count - 1)) / count, 1.0f), std::max(size.y, 1.0f)};
    std::optional<std::size_t> removed;
    for (std::size_t i = 0; i < m.pins.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (i > 0) ImGui::SameLine(0, gap);
        const ImVec2 low = ImGui::GetCursorScreenPos();
        const Rect area = {low, {low.x + each.x, low.y + each.y}};
        const bool clicked = ImGui::InvisibleButton("pin", each);
        ui.record_widget_rect(fmt::format("pin.{}", i + 1));
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        const bool on_cross = mouse.x > area.high.x - cross && mouse.y < low.y + cross;
        ui.widget_rects[fmt::format("pin.{}.remove", i + 1)] = {{area.high.x - cross, low.y},
                                                                {area.high.x, low.y + cross}};
        tooltip(on_cross ? "Removes this pin." : "Click to go to this pixel.");
        draw_small_plot(ui, m.pins[i], i + 1, state.plot, area);
        if (clicked && on_cross) removed = i;
        if (clicked && !on_cross) pick(state, state.pins[i]);
        ImGui::PopID();
    }
    if (removed) remove_pin(state, *removed);
}

}  // namespace momentscope::ui
