#include "ui/window/lesson_card.hpp"

#include <fmt/format.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "ui/model/selection.hpp"
#include "ui/widgets/rich_text.hpp"
#include "ui/workspace/measures.hpp"

namespace momentscope::ui {

namespace {

constexpr float FIELD_WIDTH = 8;  // font heights
constexpr float TEXT_LINES = 3;   // of a written answer

float spacing() {
    return ImGui::GetStyle().ItemSpacing.y;
}

/// Where the student is.
struct OpenStep {
    StepPlace place;
    const StepProgress& progress;
    const LessonStep& step() const { return place.content(); }
};

// The texts above the controls of the step, as far as they are shown.
std::string shown_text(const OpenStep& open, bool hint) {
    std::string text;
    const auto add = [&](const std::string& part) {
        if (!part.empty()) text += (text.empty() ? "" : "\n\n") + part;
    };
    if (open.place.step == 0) add(open.place.lesson->text);
    add(open.step().action);
    if (!open.step().question.empty()) add("**" + open.step().question + "**");
    if (hint && !open.step().hint.empty()) add("**Hint.** " + open.step().hint);
    return text;
}

std::string option_text(const ChoiceCheck::Option& option, std::size_t index) {
    return fmt::format("{}  {}", static_cast<char>('A' + index), option.text);
}

float option_height(const ChoiceCheck::Option& option, std::size_t index, float width) {
    const float pad = ImGui::GetStyle().FramePadding.x;
    const std::string text = option_text(option, index);
    return ImGui::CalcTextSize(text.c_str(), nullptr, false, width - 2 * pad).y +
           2 * ImGui::GetStyle().FramePadding.y;
}

float controls_height(const LessonStep& step, float width) {
    float height = 0;
    for (const Check& check : step.checks) {
        if (const auto* choice = std::get_if<ChoiceCheck>(&check))
            for (std::size_t i = 0; i < choice->options.size(); ++i)
                height += option_height(choice->options[i], i, width) + 0.5f * spacing();
        else if (std::holds_alternative<TextCheck>(check))
            height += TEXT_LINES * ImGui::GetTextLineHeight() + 2 * ImGui::GetFrameHeightWithSpacing();
        else
            height += ImGui::GetFrameHeightWithSpacing();
    }
    return height;
}

// The height of the largest step of the lesson with everything open, so that nothing moves.
float full_height(const Lesson& lesson, float width) {
    float height = 0;
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const OpenStep open = {{&lesson, i}, StepProgress()};
        const float text = std::max(rich_text_height(shown_text(open, true), width),
                                    rich_text_height(shown_text(open, false), width) +
                                        rich_text_height(lesson.steps[i].answer, width));
        height = std::max(height, text + controls_height(lesson.steps[i], width) + 2 * spacing());
    }
    return height + 2 * ImGui::GetTextLineHeightWithSpacing();  // of feedback
}

// Draws a wide button whose text wraps. True if it was clicked.
bool option_button(const Ui& ui, const std::string& text, ImVec2 size, std::size_t index, bool chosen) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 pad = ImGui::GetStyle().FramePadding;
    ImGui::PushID(static_cast<int>(index));
    const bool clicked = ImGui::InvisibleButton("option", size);
    ImGui::PopID();
    ui.record_widget_rect(fmt::format("card.choice.{}", index + 1));
    const bool pressed = ImGui::IsItemActive() || chosen;
    const ImU32 fill = ImGui::GetColorU32(pressed                  ? ImGuiCol_ButtonActive
                                          : ImGui::IsItemHovered() ? ImGuiCol_ButtonHovered
                                                                   : ImGuiCol_Button);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, {low.x + size.x, low.y + size.y}, fill, ImGui::GetStyle().FrameRounding);
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {low.x + pad.x, low.y + pad.y},
                 ImGui::GetColorU32(ImGuiCol_Text), text.c_str(), nullptr, size.x - 2 * pad.x);
    return clicked;
}

void draw_choice(const Ui& ui, Workspace& w, const OpenStep& open, const ChoiceCheck& choice, float width) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0.5f * spacing()});
    for (std::size_t i = 0; i < choice.options.size(); ++i) {
        const ChoiceCheck::Option& option = choice.options[i];
        const ImVec2 size = {width, option_height(option, i, width)};
        if (option_button(ui, option_text(option, i), size, i, open.progress.answer == option.text))
            w.lesson.answer_chosen(w, open.place, i);
    }
    ImGui::PopStyleVar();
}

void draw_number_field(const Ui& ui, Workspace& w, const OpenStep& open) {
    ImGui::SetNextItemWidth(FIELD_WIDTH * em());
    bool check = ImGui::InputTextWithHint("##typed", "such as 0.25", &w.lesson.typed,
                                          ImGuiInputTextFlags_EnterReturnsTrue);
    ui.record_widget_rect("card.typed");
    ImGui::SameLine();
    check |= ImGui::Button("check");
    ui.record_widget_rect("card.check");
    if (check) w.lesson.answer_typed(w, open.place);
}

void draw_text_field(const Ui& ui, Workspace& w, const OpenStep& open, float width) {
    const float height = TEXT_LINES * ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().FramePadding.y;
    ImGui::InputTextMultiline("##written", &w.lesson.typed, {width, height});
    ui.record_widget_rect("card.typed");
    if (ImGui::Button("keep")) w.lesson.answer_typed(w, open.place);
    ui.record_widget_rect("card.check");
    ImGui::SameLine();
    ImGui::TextDisabled("Enter begins a new line.");
}

// What a number must be, such as "2 ± 0.05" or "at most 0.02".
std::string limits_text(const Limits& limits) {
    std::string text;
    const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
    if (limits.is) add(fmt::format("wanted: {:g} ± {:g}", *limits.is, limits.within));
    if (limits.at_least) add(fmt::format("at least {:g}", *limits.at_least));
    if (limits.at_most) add(fmt::format("at most {:g}", *limits.at_most));
    return text;
}

// What the window measures now, and what the step asks for.
void draw_measured(const Workspace& w, const MeasureCheck& check) {
    const MeasureRow& row = MEASURES[static_cast<std::size_t>(check.measure)];
    const std::string limits = limits_text(check.limits);
    ImGui::TextUnformatted(fmt::format("{}: {}{}", row.name, measure_text(check.measure, w),
                                       limits.empty() ? "" : fmt::format("   ({})", limits))
                               .c_str());
    tooltip(row.help);
}

// A number that the student sets, if the step limits it on one side. What it must be exactly is asked for in
// words.
void draw_limited(const Workspace& w, const StateCheck& check) {
    if (!check.limits.at_least && !check.limits.at_most) return;
    const std::optional<double> value = number_at(check.pointer, w.shown);
    const std::string name = check.pointer.substr(check.pointer.rfind('/') + 1);
    ImGui::TextUnformatted(fmt::format("{}: {}   ({})", name, value ? fmt::format("{:.3g}", *value) : "–",
                                       limits_text(check.limits))
                               .c_str());
}

void draw_feedback(const Ui& ui, const Workspace& w, const OpenStep& open, float width) {
    const LessonWork::Feedback& feedback = w.lesson.feedback();
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
    if (!feedback.sentence.empty()) {
        const ImU32 tint = feedback.right ? ui.colors.text : ui.colors.warning;
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::ColorConvertU32ToFloat4(tint));
        ImGui::TextUnformatted((feedback.right ? "● " + feedback.sentence : feedback.sentence).c_str());
        ImGui::PopStyleColor();
    } else if (open.progress.done) {
        ImGui::TextUnformatted("● Done.");
    }
    ImGui::PopTextWrapPos();
    ui.record_widget_rect("card.feedback");
}

void draw_controls(const Ui& ui, Workspace& w, const OpenStep& open, float width) {
    for (const Check& check : open.step().checks) {
        if (const auto* choice = std::get_if<ChoiceCheck>(&check)) draw_choice(ui, w, open, *choice, width);
        if (const auto* measure = std::get_if<MeasureCheck>(&check)) draw_measured(w, *measure);
        if (const auto* state = std::get_if<StateCheck>(&check)) draw_limited(w, *state);
        if (std::holds_alternative<NumberCheck>(check)) draw_number_field(ui, w, open);
        if (std::holds_alternative<TextCheck>(check)) draw_text_field(ui, w, open, width);
    }
}

// One of the buttons at the right of the heading.
struct HeadingButton {
    const char* label;
    const char* anchor;
    const char* help;
    const char* key;
    bool enabled;
    bool wanted;  // is it what the student does next?
    std::function<void()> run;
};

std::vector<HeadingButton> heading_buttons(Workspace& w, const OpenStep& open) {
    ExplorerState& state = w.state;
    const LessonStep& step = open.step();
    const auto previous = w.course.previous(open.place);
    const auto next = w.course.next(open.place);
    const char* const onward = next && next->step == 0 ? "next lesson ▸" : "next ▸";
    return {{"hint", "card.hint", "Shows a hint.", "", !step.hint.empty(), false,
             [&state] { state.hint = !state.hint; }},
            {state.answer ? "hide answer" : "answer", "card.answer", "Shows the answer.", "",
             !step.answer.empty(), false, [&state] { state.answer = !state.answer; }},
            {"◂", "card.back", "Goes back to the step before.", "PageUp", previous.has_value(), false,
             [&state, previous] { go_to(state, *previous, false); }},
            {onward, "card.next", "Goes on.", "PageDown", next.has_value(), open.progress.done,
             [&state, next] { go_forward(state, *next); }},
            {"close", "card.close", "Hides the lesson and keeps everything as it is.", "Escape", true, false,
             [&state] { close_card(state); }}};
}

// The title, and the buttons at the right.
void draw_heading(const Ui& ui, Workspace& w, const OpenStep& open) {
    const std::vector<HeadingButton> buttons = heading_buttons(w, open);
    const float gap = 0.2f * em();
    float width = 0;
    for (const HeadingButton& button : buttons) width += button_width(button.label) + gap;
    const std::string title = fmt::format("{}  {}/{}", open.place.lesson->title, open.place.step + 1,
                                          open.place.lesson->steps.size());
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(bold_font());
    ImGui::TextUnformatted(elided(title, std::max(ImGui::GetContentRegionAvail().x - width, em())).c_str());
    ImGui::PopFont();
    ImGui::SameLine(std::max(ImGui::GetContentRegionMax().x - width + gap, 0.0f), 0);
    for (const HeadingButton& button : buttons) {
        ImGui::BeginDisabled(!button.enabled);
        if (toggle_button(button.label, button.wanted)) button.run();
        ImGui::EndDisabled();
        ui.record_widget_rect(button.anchor);
        tooltip(button.help, button.key);
        ImGui::SameLine(0, gap);
    }
    ImGui::NewLine();
}

}  // namespace

void draw_lesson_card(const Ui& ui, Workspace& w, float most) {
    const auto place = w.course.open_step(w.state);
    if (!place) return;
    const OpenStep open = {*place, std::as_const(w.lesson.progress).of(place->lesson->id, place->step)};
    const float pad = 0.5f * em();
    ImGui::PushStyleColor(ImGuiCol_ChildBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {pad, pad});
    const float width = ImGui::GetContentRegionAvail().x - 2 * pad - ImGui::GetStyle().ScrollbarSize;
    const float heading = ImGui::GetFrameHeightWithSpacing();
    const float height = std::min(2 * pad + heading + full_height(*place->lesson, width), most);
    ImGui::BeginChild("card", {0, height}, false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar |
                          ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PushID(fmt::format("{}.{}", place->lesson->id, place->step).c_str());
    draw_heading(ui, w, open);
    ImGui::BeginChild("text");
    const bool answer = w.state.answer || open.progress.done;
    draw_rich_text(ui, shown_text(open, w.state.hint && !answer), width);
    draw_controls(ui, w, open, width);
    draw_feedback(ui, w, open, width);
    if (answer) draw_rich_text(ui, open.step().answer, width);
    int& seen = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("changes"), 0);
    const int changes = static_cast<int>(w.lesson.changes());
    if (std::exchange(seen, changes) != changes && changes > 0) ImGui::SetScrollHereY(1);  // to what is said
    ImGui::EndChild();
    ImGui::PopID();
    ImGui::EndChild();
    w.widget_rects["card"] = {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()};
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

}  // namespace momentscope::ui
