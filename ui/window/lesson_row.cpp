// lesson_row.cpp -- the row of lessons, and the rings around what the open one points at.
#include <fmt/format.h>

#include <algorithm>

#include "ui/model/selection.hpp"
#include "ui/window/lesson_card.hpp"

namespace momentscope::ui {

namespace {

// The width of the whole row with titles.
float titles_width(std::span<const Lesson> lessons) {
    float width = ImGui::CalcTextSize("Lessons").x;
    for (const Lesson& lesson : lessons)
        width +=
            button_width(fmt::format("00  {} ●", lesson.title).c_str()) + ImGui::GetStyle().ItemSpacing.x;
    return width;
}

// The lesson whose title is shown where there is no room for all: the open one, or the next one to take.
const Lesson* titled_lesson(const Workspace& w) {
    if (const Lesson* open = w.course.find(w.state.card)) return open;
    const auto next = std::ranges::find_if(
        w.course.lessons(), [&](const Lesson& lesson) { return !w.lesson.progress.is_done(lesson); });
    return next == w.course.lessons().end() ? nullptr : &*next;
}

}  // namespace

void draw_lesson_row(const Ui& ui, Workspace& w) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("Lessons");
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    const bool all_titles = titles_width(w.course.lessons()) <= ImGui::GetContentRegionAvail().x;
    const Lesson* const titled = titled_lesson(w);
    int number = 1;
    for (const Lesson& lesson : w.course.lessons()) {
        const bool done = w.lesson.progress.is_done(lesson);
        const bool open = w.state.card == lesson.id;
        const bool title = all_titles || &lesson == titled;
        const std::string label =
            fmt::format("{}{}{}", number, title ? "  " + lesson.title : "", done ? " ●" : "");
        flow(button_width(label.c_str()), right, 0.3f * em());
        ImGui::PushID(lesson.id.c_str());
        if (toggle_button(label.c_str(), open)) {
            if (open)
                close_card(w.state);
            else
                open_lesson(w.state, lesson);
        }
        ImGui::PopID();
        ui.record_widget_rect(fmt::format("card.{}", lesson.id));
        if (!open)
            tooltip(fmt::format("{}. {}{}", number, lesson.title, done ? " (done)" : ""),
                    "click to start this lesson; Ctrl+Z brings everything back");
        ++number;
    }
}

void draw_highlights(const Ui& ui, const Workspace& w) {
    const auto place = w.course.open_step(w.state);
    if (!place || w.escape_is_taken ||
        ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
        return;
    const auto panel = w.widget_rects.find("panel");
    for (const std::string& name : place->content().highlight) {
        const auto found = w.widget_rects.find(name);
        if (found == w.widget_rects.end()) continue;
        Rect rect = found->second;
        const bool in_panel = panel != w.widget_rects.end() && rect.low.x >= panel->second.low.x &&
                              rect.low.y >= panel->second.low.y - em();
        if (in_panel && rect.high.y > panel->second.high.y) continue;  // it is scrolled out of sight
        const float grow = 0.2f * em();
        ImGui::GetForegroundDrawList()->AddRect({rect.low.x - grow, rect.low.y - grow},
                                                {rect.high.x + grow, rect.high.y + grow},
                                                ui.colors.wrapping_zone, 0.3f * em(), 0, 0.15f * em());
    }
}

}  // namespace momentscope::ui
