// lesson_cards.cpp -- the "Try this" row and the open card.
#include <fmt/format.h>

#include <algorithm>

#include "ui/model/lessons.hpp"
#include "ui/model/selection.hpp"
#include "ui/window/parts.hpp"

namespace momentscope::ui {

namespace {

constexpr float NARROW_CARD = 0.25f;  // the height of a card in a narrow window, as a share of the window

// The error of the picked pixel in linear RGB.
std::string error_text(const Workspace& w) {
    return fmt::format("The colour of this pixel is off by {:.4f}.", w.measurement().breakdown.error);
}

// The height of the text with the answer, so that nothing moves when it opens.
float full_height(const Lesson& lesson, float wrap) {
    const auto height_of = [&](const char* text) {
        return ImGui::CalcTextSize(text, nullptr, false, wrap).y + ImGui::GetStyle().ItemSpacing.y;
    };
    float height = height_of(lesson.text) + height_of(lesson.answer);
    ImGui::PushFont(bold_font());
    height += height_of(lesson.question);
    ImGui::PopFont();
    return height + (lesson.shows_error ? ImGui::GetTextLineHeightWithSpacing() : 0);
}

// The title, and the buttons of the card at the right.
void draw_heading(const Ui& ui, ExplorerState& state, const Lesson& lesson) {
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(bold_font());
    ImGui::TextUnformatted(lesson.title);
    ImGui::PopFont();
    const char* const answer = state.answer ? "hide answer" : "show answer";
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float buttons = button_width(answer) + gap + button_width("close");
    ImGui::SameLine(std::max(ImGui::GetContentRegionMax().x - buttons, ImGui::GetItemRectSize().x + 2 * gap));
    if (ImGui::Button(answer)) state.answer = !state.answer;
    ui.record_widget_rect("card.answer");
    ImGui::SameLine();
    if (ImGui::Button("close")) close_card(state);
    ui.record_widget_rect("card.close");
    tooltip("Hides the card and keeps everything as it is.", "Escape");
}

void draw_text(const Workspace& w, const Lesson& lesson) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(lesson.text);
    ImGui::PushFont(bold_font());
    ImGui::TextUnformatted(lesson.question);
    ImGui::PopFont();
    if (lesson.shows_error) ImGui::TextUnformatted(error_text(w).c_str());
    if (w.state.answer) ImGui::TextUnformatted(lesson.answer);
    ImGui::PopTextWrapPos();
}

// The width of the whole row with titles.
float titles_width() {
    float width = ImGui::CalcTextSize("Try this").x;
    for (const Lesson& lesson : lessons())
        width += button_width(fmt::format("0  {}", lesson.title).c_str()) + ImGui::GetStyle().ItemSpacing.x;
    return width;
}

}  // namespace

void draw_card(const Ui& ui, Workspace& w, float most) {
    const Lesson* lesson = find_lesson(w.state.card);
    if (lesson == nullptr) return;
    const float pad = 0.5f * em();
    ImGui::PushStyleColor(ImGuiCol_ChildBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {pad, pad});
    const float wrap = ImGui::GetContentRegionAvail().x - 2 * pad - ImGui::GetStyle().ScrollbarSize;
    const float heading = ImGui::GetFrameHeightWithSpacing();
    const float height = std::min(2 * pad + heading + full_height(*lesson, wrap), most);
    ImGui::BeginChild("card", {0, height}, false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar |
                          ImGuiWindowFlags_NoScrollWithMouse);
    draw_heading(ui, w.state, *lesson);
    ImGui::BeginChild("text");
    draw_text(w, *lesson);
    ImGui::EndChild();
    ImGui::EndChild();
    w.widget_rects["card"] = {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()};
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

void draw_lessons(const Ui& ui, Workspace& w) {
    if (is_narrow())  // the menu has the lessons, too
        return draw_card(ui, w, NARROW_CARD * ImGui::GetMainViewport()->Size.y);
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("Try this");
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    const bool numbers_only = titles_width() > ImGui::GetContentRegionAvail().x;
    int number = 1;
    for (const Lesson& lesson : lessons()) {
        const std::string label =
            numbers_only ? fmt::format("{}", number) : fmt::format("{}  {}", number, lesson.title);
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
        if (!open)
            tooltip(fmt::format("{}. {}", lesson.title, lesson.question),
                    "click to start this lesson; Ctrl+Z brings everything back");
        ++number;
    }
}

}  // namespace momentscope::ui
