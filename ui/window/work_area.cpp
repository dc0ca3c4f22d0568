// work_area.cpp -- scene, plot and tabs side by side.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ui/panels/moment_table.hpp"
#include "ui/panels/panels.hpp"
#include "ui/plot/pinned_plots.hpp"
#include "ui/plot/plot_legend.hpp"
#include "ui/widgets/shortcut.hpp"
#include "ui/window/lesson_card.hpp"
#include "ui/window/parts.hpp"

namespace momentscope::ui {

namespace {

constexpr float MIN_SHARE = 0.2f, MAX_SHARE = 0.8f;
constexpr float PINNED_SHARE = 0.26f;  // of the plot
constexpr float LEAST_PINS = 5;        // font heights; pins are not plotted in less
constexpr float MOST_CARD = 0.45f;     // the height of an open card, as a share of scene and card
constexpr float ENOUGH_TABS = 12;      // font heights
// The height of the smallest window in which the curves keep their height: 1024x768 with text of scale 1.5.
constexpr float LEAST_WINDOW = 34;  // font heights
constexpr float LEAST_TABS = 4.4f;  // font heights

// The share of the height that the scene takes of its share of the width, if it lies above the plot.
constexpr float STACKED_SHARE = 0.6f;

// A draggable bar between two areas. A double-click restores the default. Changes the share of the area
// before the bar.
void splitter(const Ui& ui, const char* name, bool vertical, ImVec2 size, float room, float default_value,
              float& share) {
    ImGui::InvisibleButton(name, {std::max(size.x, 1.0f), std::max(size.y, 1.0f)});
    ui.record_widget_rect(name);
    const bool hot = ImGui::IsItemHovered() || ImGui::IsItemActive();
    tooltip("Drag to divide the space; double-click to restore the original division.");
    if (hot) ImGui::SetMouseCursor(vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    const float moved = vertical ? ImGui::GetIO().MouseDelta.x : ImGui::GetIO().MouseDelta.y;
    if (ImGui::IsItemActive() && room > 1) share = std::clamp(share + moved / room, MIN_SHARE, MAX_SHARE);
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) share = default_value;
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const ImVec2 middle = {0.5f * (low.x + high.x), 0.5f * (low.y + high.y)};
    const ImU32 tint = ImGui::GetColorU32(hot ? ImGuiCol_CheckMark : ImGuiCol_Border);
    const float half = 1.2f * em();
    ImGui::GetWindowDrawList()->AddLine({middle.x - (vertical ? 0 : half), middle.y - (vertical ? half : 0)},
                                        {middle.x + (vertical ? 0 : half), middle.y + (vertical ? half : 0)},
                                        tint, 0.15f * em());
}

// The names of the tabs, and the open one.
void draw_tabs(const Ui& ui, Workspace& w) {
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    for (std::size_t i = 0; i < PANELS.size(); ++i) {
        const PanelRow& row = PANELS[i];
        if (is_hidden(w, row.key)) continue;
        if (i > 0) flow(button_width(row.name), right, 0.2f * em());
        if (toggle_button(row.name, w.state.panel == row.id)) w.state.panel = row.id;
        ui.record_widget_rect(fmt::format("tab.{}", i + 1));
        tooltip(row.help, panel_shortcut(i));
    }
    ImGui::BeginChild("panel");
    if (is_hidden(w, PANELS[static_cast<std::size_t>(w.state.panel)].key))
        ImGui::TextWrapped("The lesson hides this tab until you have answered.");
    else
        draw_open_panel(ui, w);
    ImGui::EndChild();
    w.widget_rects["panel"] = {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()};
}

/// The height of the plot with its pins, and of the pins alone.
struct PlotHeights {
    float all, pins;
};

// The plot gets its share, but at least what its curves need; its pins and its legend, too, where the tabs
// have enough. room: the height of plot and tabs.
PlotHeights plot_heights(const Workspace& w, float width, float room) {
    const bool is_low = ImGui::GetMainViewport()->Size.y < LEAST_WINDOW * em();
    const float curves = is_low ? 0 : w.plot_panel.least_height();
    const bool has_pins = !w.state.pins.empty() && !w.state.ray;
    const float least_pins = has_pins ? LEAST_PINS * em() : 0;
    const float legend = legend_height(w.measurement(), width);
    const bool legend_fits = room - curves - legend - least_pins >= ENOUGH_TABS * em();
    const float least = curves + (legend_fits ? legend : 0);
    const float wanted = std::max(w.state.plot_share * room, least + least_pins);
    const float all = std::max(std::floor(std::min(wanted, room - LEAST_TABS * em())), 1.0f);
    const float pins = std::floor(std::min(all - least, std::max(PINNED_SHARE * all, least_pins)));
    return {all, has_pins && pins >= least_pins - 1 ? pins : 0};  // 1: rounding to pixels
}

void draw_right_side(const Ui& ui, Workspace& w, const WorkArea& area) {
    const ImVec2 size = area.rest;
    if (w.picked.empty()) return ImGui::Dummy(size);  // the first scene is not loaded yet
    if (w.present) return w.plot_panel.draw(ui, w.measurement(), w.state, size);
    const auto [plot, pins] = plot_heights(w, size.x, size.y - area.bar);
    ImGui::BeginGroup();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 0.2f * em()});
    w.plot_panel.draw(ui, w.measurement(), w.state, {size.x, plot - pins});
    if (pins > 0) draw_pinned_plots(ui, w.measurement(), w.state, {size.x, pins - 0.2f * em()});
    ImGui::PopStyleVar();
    splitter(ui, "split.plot", false, {size.x, area.bar}, size.y, ExplorerState().plot_share,
             w.state.plot_share);
    ImGui::BeginChild(
        "tabs", {size.x, std::max(size.y - plot - area.bar - 2 * ImGui::GetStyle().ItemSpacing.y, 1.0f)});
    draw_tabs(ui, w);
    ImGui::EndChild();
    ImGui::EndGroup();
}

// The picture, or what is known of a ray without one.
void draw_left_side(const Ui& ui, Workspace& w, const WorkArea& area) {
    if (!w.state.ray || w.picked.empty())
        return w.scene_panel.draw_picture(ui, w.measurement(), w.scene_picture, w.state);
    const ImVec2 side = ImGui::GetItemRectMin();
    draw_own_ray(ui, w, w.widget_rects["scene"]);
    ImGui::SetCursorScreenPos(side);
    ImGui::Dummy(area.scene);  // what follows finds its place as behind the picture
}

// A message stays until the next input of the user.
void clear_message_on_input(Status& status) {
    const ImGuiIO& io = ImGui::GetIO();
    bool input = io.InputQueueCharacters.Size > 0;
    for (const bool clicked : io.MouseClicked) input |= clicked;
    for (int key = 0; key < IM_ARRAYSIZE(io.KeysDown); ++key) input |= ImGui::IsKeyPressed(key, false);
    if (input && !pressed({.key = 256})) status.message.clear();  // Escape is handled elsewhere
}

}  // namespace

bool is_narrow() {
    const ImVec2 window = ImGui::GetMainViewport()->Size;
    return window.x < 48 * em() && window.y > window.x;
}

WorkArea draw_scene_controls(const Ui& ui, Workspace& w) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float bar = 0.6f * em();
    const float gap = ImGui::GetStyle().ItemSpacing.y;
    const bool status = !w.present || !w.status.message.empty();
    const float below = status ? ImGui::GetTextLineHeightWithSpacing() + gap : 0;
    const ImVec2 size = {room.x, std::max(room.y - below, 1.0f)};
    WorkArea area = {
        .size = size, .scene = size, .rest = size, .bar = bar, .stacked = is_narrow(), .picture = {}};
    const auto divide = [&](float all, float share, float& scene, float& rest) {
        scene = std::max(std::floor(share * (all - bar)), 1.0f);
        rest = std::max(all - scene - bar, 1.0f);
    };
    if (area.stacked)
        divide(size.y, STACKED_SHARE * w.state.scene_share, area.scene.y, area.rest.y);
    else
        divide(size.x, w.state.scene_share, area.scene.x, area.rest.x);
    clear_message_on_input(w.status);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::BeginChild("scene side", area.scene, false,
                      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    if (!area.stacked) draw_lesson_card(ui, w, MOST_CARD * area.scene.y);
    area.picture =
        w.scene_panel.draw_controls(ui, w.measurement(), w.scene_picture, w.state,
                                    ImGui::GetContentRegionAvail(), !w.present && !w.state.ray, w.status);
    ImGui::EndChild();
    ImGui::PopStyleVar();
    return area;
}

void draw_work_area(const Ui& ui, Workspace& w, const WorkArea& area) {
    draw_left_side(ui, w, area);
    const float original = ExplorerState().scene_share;
    if (area.stacked) {
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 0});
        splitter(ui, "split.scene", false, {area.size.x, area.bar}, STACKED_SHARE * area.size.y, original,
                 w.state.scene_share);
        ImGui::PopStyleVar();
    } else {
        ImGui::SameLine(0, 0);
        splitter(ui, "split.scene", true, {area.bar, area.size.y}, area.size.x, original,
                 w.state.scene_share);
        ImGui::SameLine(0, 0);
    }
    draw_right_side(ui, w, area);
}

}  // namespace momentscope::ui
