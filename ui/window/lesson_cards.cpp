// lesson_cards.cpp -- the "Try this" row and the open card.
#include <fmt/format.h>

#include <algorithm>

#include "ui/model/lessons.hpp"
#include "ui/model/selection.hpp"
#include "ui/window/parts.hpp"

namespace momentscope::ui {

namespace {

// The error of the picked pixel in linear RGB.
std::string error_text(const Workspace& w) {
    return fmt::format("The colour of this pixel is off by {:.4f}.", w.measurement().breakdown.error);
}

void draw_card(const Ui& ui, Workspace& w) {
    const Lesson* lesson = find_lesson(w.state.card);
    if (lesson == nullptr) return;
    ImGui::PushStyleColor(ImGuiCol_ChildBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
    const float pad = 0.5f * em();
    const float width = ImGui::GetContentRegionAvail().x;
    const float wrap = std::max(width - 12 * em(), 10 * em());
    const float line = ImGui::GetTextLineHeightWithSpacing();
    float height = 2 * pad + ImGui::CalcTextSize(lesson->text, nullptr, false, wrap).y + 0.4f * line;
    ImGui::PushFont(bold_font());
    height += ImGui::CalcTextSize(lesson->question, nullptr, false, wrap).y;
    ImGui::PopFont();
    if (w.state.answer) height += 0.4f * line + ImGui::CalcTextSize(lesson->answer, nullptr, false, wrap).y;
    if (lesson->shows_error) height += line;
    height = std::max(height, 2 * pad + 2 * ImGui::GetFrameHeightWithSpacing());
    ImGui::BeginChild("card", {0, height}, false,
                      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::SetCursorPos({pad, pad});
    ImGui::BeginGroup();
    ImGui::PushTextWrapPos(pad + wrap);
    ImGui::TextUnformatted(lesson->text);
    ImGui::PushFont(bold_font());
    ImGui::TextUnformatted(lesson->question);
    ImGui::PopFont();
    if (lesson->shows_error) ImGui::TextUnformatted(error_text(w).c_str());
    if (w.state.answer) ImGui::TextUnformatted(lesson->answer);
    ImGui::PopTextWrapPos();
    ImGui::EndGroup();
    const float button = 9.5f * em();
    ImGui::SetCursorPos({width - button - pad, pad});
    if (ImGui::Button(w.state.answer ? "hide answer" : "show answer", {button, 0}))
        w.state.answer = !w.state.answer;
    ui.record_widget_rect("card.answer");
    ImGui::SetCursorPos({width - button - pad, pad + ImGui::GetFrameHeightWithSpacing()});
    if (ImGui::Button("close card", {button, 0})) close_card(w.state);
    ui.record_widget_rect("card.close");
    tooltip("Hides the card and keeps everything as it is.", "Escape");
    ImGui::EndChild();
    w.widget_rects["card"] = {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()};
    ImGui::PopStyleColor();
}

}  // namespace

void draw_lessons(const Ui& ui, Workspace& w) {
    if (is_narrow()) return draw_card(ui, w);  // the menu has the lessons, too
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("Try this");
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    int number = 1;
    for (const Lesson& lesson : lessons()) {
        const std::string label = fmt::format("{}  {}", number, lesson.title);
        const float width = ImGui::CalcTextSize(label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
        flow(width, right, ImGui::GetStyle().ItemSpacing.x);
        const bool open = w.state.card == lesson.id;
        if (toggle_button(label.c_str(), open)) {
            if (open)
                close_card(w.state);
            else
                open_lesson(w.state, lesson);
        }
        ui.record_widget_rect(fmt::format("card.{}", lesson.id));
        if (!open) tooltip(lesson.question, "click to start this lesson; Ctrl+Z brings everything back");
        ++number;
    }
    draw_card(ui, w);
}

}  // namespace momentscope::ui
