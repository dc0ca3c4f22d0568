#include "ui/window/explorer.hpp"

#include <fmt/format.h>
#include <imgui_internal.h>

#include <cfloat>
#include <utility>

#include "ui/commands/command_palette.hpp"
#include "ui/model/selection.hpp"
#include "ui/window/lesson_card.hpp"
#include "ui/window/notices.hpp"
#include "ui/window/parts.hpp"
#include "ui/window/update.hpp"
#include "ui/workspace/keeping.hpp"
#include "ui/workspace/presenting.hpp"

namespace momentscope::ui {

namespace {

constexpr float NARROW_CARD = 0.25f;  // the height of a card in a narrow window, as a share of the window

bool shows_dialog(const Workspace& w) {
    return w.files.is_open() || w.palette.open;
}

// On Escape, an open list, menu or other popup closes first. The dialog and the palette are popups, too, but
// close themselves, and a text field that is being edited goes before all of them.
bool close_popup_on_escape(const Workspace& w) {
    constexpr int ESCAPE = 256;
    const int stay = shows_dialog(w) ? 1 : 0;
    const int open = ImGui::GetCurrentContext()->OpenPopupStack.Size;
    if (open <= stay || ImGui::GetIO().WantTextInput || !ImGui::IsKeyPressed(ESCAPE, false)) return false;
    ImGui::ClosePopupToLevel(open - 1, true);
    ImGui::GetIO().KeysDownDuration[ESCAPE] = FLT_MIN;  // held, but no longer newly pressed
    return true;
}

void begin_window(bool has_menus) {
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(viewport.Pos);
    ImGui::SetNextWindowSize(viewport.Size);
    ImGui::Begin("Momentscope", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     (has_menus ? ImGuiWindowFlags_MenuBar : 0) | ImGuiWindowFlags_NoBringToFrontOnFocus |
                     ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoSavedSettings);
}

// A session may show a lesson that is not here.
void keep_known_lesson(Workspace& w) {
    if (w.state.card.empty() || w.course.find(w.state.card) != nullptr) return;
    w.status.say(
        fmt::format("There is no lesson '{}' here; open its file with Lessons > Open lesson.", w.state.card));
    close_card(w.state);
}

void draw_whole(const Ui& ui, Workspace& w) {
    if (!w.present) {
        draw_menu_bar(ui, w);
        if (!is_narrow()) draw_lesson_row(ui, w);
    }
    if (is_narrow()) draw_lesson_card(ui, w, NARROW_CARD * ImGui::GetMainViewport()->Size.y);
    const WorkArea area = draw_scene_controls(ui, w);
    update_window(w, area.picture, {ImGui::IsAnyMouseDown(), ImGui::GetIO().DeltaTime});
    draw_work_area(ui, w, area);
    if (!w.present || !w.status.message.empty()) draw_status_line(ui, w);
    w.lesson.update(w, w.course.open_step(w.state));
}

// What lies above the window.
void draw_above(const Ui& ui, Workspace& w) {
    draw_help(ui, w.help);
    w.files.draw(ui, w);
    if (const Command* chosen = draw_palette(ui, w)) chosen->run(w);
    draw_reading_notice(ui, w);
}

}  // namespace

Explorer::Explorer(Renderer& renderer, ExplorerState state, WindowOptions options)
    : workspace_(renderer, std::move(state), std::move(options)) {}

void Explorer::frame() {
    Workspace& w = workspace_;
    if (styled_ != w.state.theme) {
        apply_style(w.state.theme, w.options.scale);
        styled_ = w.state.theme;
    }
    w.widget_rects.clear();
    move_on(w, ImGui::GetIO().DeltaTime);
    keep_known_lesson(w);
    take_results(w);
    const Ui ui = {palette(w.state.theme), w.widget_rects, w.gl.can};
    begin_window(w.options.embedding.shown == Shown::window && !w.present);
    const bool reading = w.scene.is_reading();  // it may change within this frame
    w.escape_is_taken =
        close_popup_on_escape(w) || shows_dialog(w) || reading || ImGui::GetIO().WantTextInput;
    w.comparison.flip(!w.state.ray && !shows_dialog(w) && (held({.key = 'G'}) || w.scene_panel.flip_held()));

    ImGui::BeginDisabled(reading);  // the state must not change while a scene is read
    if (w.options.embedding.shown == Shown::window)
        draw_whole(ui, w);
    else
        draw_embedded(ui, w);
    ImGui::EndDisabled();
    ImGui::End();
    draw_highlights(ui, w);
    draw_above(ui, w);
    if (w.picture_waits) ui::draw_waiting(*ImGui::GetForegroundDrawList(), w);
    run_pressed_commands(w);
    if (is_at_a_step()) w.history.record(w.state);
    keep_changes(w);
}

bool Explorer::is_at_a_step() const {
    return workspace_.state == workspace_.shown && !workspace_.moving && !ImGui::IsAnyMouseDown() &&
           !ImGui::IsAnyItemActive();
}

void Explorer::draw_waiting(ImDrawList& list) const {
    ui::draw_waiting(list, workspace_);
}

}  // namespace momentscope::ui
