// explorer_layout.cpp -- the layout of the window.
#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "ui/compare_panel.hpp"
#include "ui/explorer.hpp"
#include "ui/lessons.hpp"
#include "ui/side_panels.hpp"
#include "ui/steps_panel.hpp"

namespace momentscope::ui {

namespace {

constexpr float MIN_SHARE = 0.2f, MAX_SHARE = 0.8f;

ImVec4 color_of(ImU32 tint) {
    return ImGui::ColorConvertU32ToFloat4(tint);
}

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

}  // namespace

// On Escape, an open list, menu or other popup closes first. The dialog and the palette are popups, too, but
// close themselves, and a text field that is being edited goes before all of them.
bool Explorer::close_popup_on_escape() const {
    constexpr int ESCAPE = 256;
    const int stay = files_.is_open() || palette_.is_open() ? 1 : 0;
    const int open = ImGui::GetCurrentContext()->OpenPopupStack.Size;
    if (open <= stay || ImGui::GetIO().WantTextInput || !ImGui::IsKeyPressed(ESCAPE, false)) return false;
    ImGui::ClosePopupToLevel(open - 1, true);
    ImGui::GetIO().KeysDownDuration[ESCAPE] = FLT_MIN;  // held, but no longer newly pressed
    return true;
}

void Explorer::frame() {
    if (styled_ != state_.theme) {
        apply_style(state_.theme, options_.scale);
        styled_ = state_.theme;
    }
    widget_rects_.clear();
    stress_panel_.poll();
    poll_tuning();
    comparison_.poll();
    if (!is_loading_scene()) chart_panel_.work(state_, message_);
    const Ui ui = {palette(state_.theme), widget_rects_};
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(viewport.Pos);
    ImGui::SetNextWindowSize(viewport.Size);
    ImGui::Begin("Momentscope", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_MenuBar |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse |
                     ImGuiWindowFlags_NoSavedSettings);
    const bool dialog = files_.is_open() || palette_.is_open();
    const bool reading = is_loading_scene();  // it may change within this frame
    escape_is_taken_ = close_popup_on_escape() || dialog || reading || ImGui::GetIO().WantTextInput;
    ImGui::BeginDisabled(reading);  // the state must not change while a scene is read
    flipped_ = !state_.ray && !dialog && (held({.key = 'G'}) || flip_button_held_);
    draw_menu(ui);
    draw_lessons(ui);
    draw_work_area(ui);
    draw_status(ui);
    ImGui::EndDisabled();
    ImGui::End();
    draw_help(ui, help_);
    draw_files(ui);
    if (const Command* chosen = palette_.draw(ui, *this)) chosen->run(*this);
    draw_loading(ui);
    run_pressed_commands(*this);
    // Record a drag as one step, and only states that could be shown.
    if (state_ == shown_state_ && !ImGui::IsAnyMouseDown() && !ImGui::IsAnyItemActive())
        history_.record(state_);
}

void Explorer::draw_menu(const Ui& ui) {
    if (!ImGui::BeginMenuBar()) return;
    for (const Menu& menu : menus()) {
        const bool open = ImGui::BeginMenu(menu.title);
        ui.record_widget_rect(fmt::format("menu.{}", menu.id));
        if (!open) continue;
        for (const Command& command : commands()) {
            if (!command.id.starts_with(std::string(menu.id) + ".")) continue;
            const std::string key =
                command.keys.empty() ? "" : command.keys.front() + (command.run ? "" : " (hold)");
            const bool checked = command.checked && command.checked(*this);
            if (ImGui::MenuItem(command.name.c_str(), key.c_str(), checked,
                                command.run && is_enabled(command, *this)))
                command.run(*this);
            ui.record_widget_rect(command.id);
            tooltip(command.help);
        }
        ImGui::EndMenu();
    }
    ImGui::EndMenuBar();
}

void Explorer::draw_work_area(const Ui& ui) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float bar = 0.6f * em();
    const float gap = ImGui::GetStyle().ItemSpacing.y;
    const ImVec2 size = {room.x, std::max(room.y - ImGui::GetTextLineHeightWithSpacing() - gap, 1.0f)};
    const float left = std::max(std::floor(state_.scene_share * (size.x - bar)), 1.0f);
    message_until_input();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::BeginChild("scene side", {left, size.y}, false,
                      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    if (focus_go_to_) scene_panel_.focus_go_to();
    focus_go_to_ = false;
    update(scene_panel_.draw_controls(ui, measurement_, picture_, state_, {left, size.y}, message_));
    flip_button_held_ = scene_panel_.flip_held();
    scene_panel_.draw_picture(ui, measurement_, picture_, state_);
    ImGui::EndChild();
    ImGui::PopStyleVar();
    ImGui::SameLine(0, 0);
    splitter(ui, "split.scene", true, {bar, size.y}, size.x, ExplorerState().scene_share, state_.scene_share);
    ImGui::SameLine(0, 0);
    draw_right_side(ui, {std::max(size.x - left - bar, 1.0f), size.y});
}

void Explorer::draw_right_side(const Ui& ui, ImVec2 size) {
    if (measurement_.curve.technique == nullptr)
        return ImGui::Dummy(size);  // the first scene is not loaded yet
    const float bar = 0.6f * em();
    const float plot = std::max(std::floor(state_.plot_share * size.y), 1.0f);
    const float pins = state_.pins.empty() || state_.ray ? 0.0f : std::floor(0.26f * plot);
    ImGui::BeginGroup();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 0.2f * em()});
    plot_panel_.draw(ui, measurement_, state_, {size.x, plot - pins});
    if (pins > 0) draw_pinned_plots(ui, measurement_, state_, {size.x, pins - 0.2f * em()});
    ImGui::PopStyleVar();
    splitter(ui, "split.plot", false, {size.x, bar}, size.y, ExplorerState().plot_share, state_.plot_share);
    ImGui::BeginChild("tabs",
                      {size.x, std::max(size.y - plot - bar - 2 * ImGui::GetStyle().ItemSpacing.y, 1.0f)});
    draw_tabs(ui);
    ImGui::EndChild();
    ImGui::EndGroup();
}

void Explorer::draw_tabs(const Ui& ui) {
    constexpr const char* HELP[] = {"Scene, technique and parameters.",
                                    "The history of the pixel: every fragment with its transmittance T.",
                                    "What the technique does and what it costs.",
                                    "The reconstruction at the query depth, step by step.",
                                    "Move, add and colour fragments by hand.",
                                    "Where techniques fail: all of them under difficult conditions.",
                                    "How far the picture is from a reference.",
                                    "Time against error of all techniques, and advice."};
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    for (std::size_t i = 0; i < PANEL_NAMES.size(); ++i) {
        if (i > 0) flow(button_width(PANEL_NAMES[i]), right, 0.2f * em());
        if (toggle_button(PANEL_NAMES[i], state_.panel == static_cast<Panel>(i)))
            state_.panel = static_cast<Panel>(i);
        ui.record_widget_rect(fmt::format("tab.{}", i + 1));
        tooltip(HELP[i], fmt::format("Ctrl+{}", i + 1));
    }
    ImGui::BeginChild("panel");
    switch (state_.panel) {
        case Panel::controls:
            if (seen_from_light(state_))
                draw_shadow_controls(ui, scene_.light, light_distance_, state_,
                                     message_);  // the plot shows the light's ray
            draw_control_panel(ui, renderer_.ordered_access(), state_, to_type_, message_);
            draw_tuning(ui);
            draw_picture_controls(ui, state_, message_);
            if (!seen_from_light(state_))
                draw_shadow_controls(ui, scene_.light, light_distance_, state_, message_);
            break;
        case Panel::fragments:
            draw_fragment_panel(ui, measurement_, state_);
            break;
        case Panel::technique:
            draw_technique_panel(ui, measurement_, state_);
            break;
        case Panel::steps:
            draw_steps_panel(ui, measurement_);
            break;
        case Panel::editor:
            ray_editor_.draw(ui, measurement_, state_, message_);
            break;
        case Panel::stress:
            stress_panel_.draw(ui, state_, message_);
            break;
        case Panel::compare:
            worst_wanted_ |= draw_compare_panel(ui, renderer_.ordered_access(), comparison_, state_);
            break;
        case Panel::chart:
            draw_chart_panel(ui);
            break;
    }
    ImGui::EndChild();
    widget_rects_["panel"] = {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()};
}

// A message stays until the next input of the user.
void Explorer::message_until_input() {
    const ImGuiIO& io = ImGui::GetIO();
    bool input = io.InputQueueCharacters.Size > 0;
    for (const bool clicked : io.MouseClicked) input |= clicked;
    for (int key = 0; key < IM_ARRAYSIZE(io.KeysDown); ++key) input |= ImGui::IsKeyPressed(key, false);
    if (input && !pressed({.key = 256})) message_.clear();  // Escape is handled elsewhere
}

void Explorer::draw_status(const Ui& ui) {
    if (!message_.empty()) {
        ImGui::TextColored(color_of(ui.colors.warning), "%s", message_.c_str());
        ui.record_widget_rect("status");
        tooltip(message_);
        return;
    }
    if (measurement_.curve.technique == nullptr) return ImGui::TextUnformatted("Reading the first scene.");
    std::string status = state_.ray ? std::string("view ray without a scene")
                                    : fmt::format("pixel {}, {}", measurement_.pixel.x, measurement_.pixel.y);
    status += fmt::format("   {}   absorbance {:.4g}",
                          fragment_count_text(measurement_.capture.ray.fragments.size()),
                          measurement_.curve.total_absorbance);
    if (options_.show_times && !state_.ray) {
        const PassTimes& t = renderer_.pass_times();
        status += fmt::format("   ms: opaque {:.1f}, first pass {:.1f}, second {:.1f}, composite {:.1f}",
                              t.opaque, t.moments, t.color, t.composite);
    }
    ImGui::TextUnformatted(status.c_str());
    ui.record_widget_rect("status");
    tooltip(
        "The picked pixel, what lies on its ray, and the time that the GL took for the last run of each pass.");
    const std::string gl = gl_.software ? fmt::format("no GPU: {}", gl_.renderer) : gl_.renderer;
    const float width = std::min(ImGui::CalcTextSize(gl.c_str()).x, 0.35f * ImGui::GetContentRegionMax().x);
    ImGui::SameLine(std::max(ImGui::GetContentRegionMax().x - width, 1.0f));
    ImGui::TextDisabled("%s", gl.c_str());
    ui.record_widget_rect("status.gl");
    std::string missing = fmt::format("OpenGL {}, {}", gl_.version, gl_.renderer);
    for (const MissingFeature& feature : gl_.missing)
        missing += fmt::format("\nmissing: {}; {}.", feature.feature, feature.consequence);
    if (gl_.missing.empty()) missing += "\nNothing that Momentscope could use is missing.";
    tooltip(missing);
}

void Explorer::draw_loading(const Ui& ui) {
    if (!is_loading_scene()) return;
    const ImVec2 room = ImGui::GetMainViewport()->Size;
    ImGui::SetNextWindowPos({0.5f * room.x, 0.4f * room.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(26 * em(), room.x), 0});
    ImGui::Begin("Reading###loading", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings);
    ImGui::TextWrapped("Reading %s", loader_.name().c_str());
    const float top = ImGui::GetCursorPosY();
    ImGui::TextWrapped("%s", loader_.stage().c_str());
    // Keep the button in place, however long the text is.
    ImGui::SetCursorPosY(top + 3 * ImGui::GetTextLineHeightWithSpacing());
    const double seconds = loader_.seconds();
    const auto sweep =
        static_cast<float>(seconds - std::floor(seconds));  // the duration is not known in advance
    ImGui::ProgressBar(sweep, {-1, 0}, fmt::format("{:.1f} s", seconds).c_str());
    if (ImGui::Button("Cancel", {6 * em(), 0}) || pressed({.key = 256})) loader_.cancel();
    ui.record_widget_rect("loading.cancel");
    tooltip("Stops reading; the previous scene stays.", "Escape");
    ImGui::End();
}

}  // namespace momentscope::ui
