#include "ui/workspace/lesson_work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/support/error.hpp"
#include "ui/workspace/measures.hpp"

namespace momentscope::ui {

namespace {

LessonWork::Feedback judged_number(const NumberCheck& check, const std::string& typed, const Workspace& w) {
    const double number = typed_number(typed);
    const auto right = measured(check.measure, w);
    if (!right) throw Error("The window does not show what this asks for; go back to the start of the step.");
    if (std::abs(number - *right) <= check.within) return {"Right.", true};
    for (const NumberCheck::Mistake& mistake : check.mistakes)
        if (std::abs(number - mistake.number) <= check.within) return {mistake.why, false};
    return {fmt::format("Not yet: {} is too {}.", number, number < *right ? "small" : "great"), false};
}

std::string greatest_cause(const ErrorBreakdown& breakdown) {
    const auto greatest = std::ranges::max_element(breakdown.contributions, {}, &Contribution::share);
    return greatest == breakdown.contributions.end() ? "" : greatest->cause;
}

LessonWork::Feedback judged_text(const TextCheck& check, const std::string& typed) {
    const std::size_t words = word_count(typed);
    if (words >= check.words) return {"Kept for your teacher.", true};
    return {fmt::format("Write at least {} words; these are {}.", check.words, words), false};
}

}  // namespace

bool state_checks_hold(const Workspace& w, const LessonStep& step) {
    return std::ranges::all_of(step.checks, [&](const Check& check) {
        if (const auto* state = std::get_if<StateCheck>(&check)) return holds(*state, w.shown);
        if (const auto* measure = std::get_if<MeasureCheck>(&check)) {
            const auto value = measured(measure->measure, w);
            return value && measure->limits.hold(*value);
        }
        return true;
    });
}

bool is_hidden(const Workspace& w, std::string_view what) {
    const auto place = w.course.open_step(w.state);
    return place && hides(place->content(), what) && !w.state.answer &&
           !std::as_const(w.lesson.progress).of(place->lesson->id, place->step).done;
}

bool asks_answer(const LessonStep& step) {
    return check_of<NumberCheck>(step.checks) != nullptr || check_of<ChoiceCheck>(step.checks) != nullptr ||
           check_of<TextCheck>(step.checks) != nullptr;
}

void LessonWork::update(const Workspace& w, const std::optional<StepPlace>& open) {
    const std::string lesson = open ? open->lesson->id : "";
    const std::size_t step = open ? open->step : 0;
    changed_ = false;
    if (lesson != lesson_ || step != step_) {
        lesson_ = lesson;
        step_ = step;
        feedback_ = {};
        cause_.clear();
        answered_right_ = false;
        typed = open && check_of<TextCheck>(open->content().checks) != nullptr
                    ? std::as_const(progress).of(lesson, step).answer
                    : "";
    }
    if (open && cause_.empty() && measures(open->content(), MeasureId::color_error) && w.shown == w.state) {
        cause_ = greatest_cause(w.measurement().breakdown);
        verdict_ = w.measurement().breakdown.sentence;
    }
    if (!open || open->content().checks.empty() || w.present) return;  // a lecture does not count as progress
    const LessonStep& content = open->content();
    if (std::as_const(progress).of(lesson, step).done || (asks_answer(content) && !answered_right_) ||
        !state_checks_hold(w, content))
        return;
    progress.of(lesson, step).done = true;
    if (answered_right_ && !feedback_.right) feedback_ = {"Right.", true};  // what was missing is done now
    ++changes_;
    changed_ = true;
}

void LessonWork::judge(const Workspace& w, const StepPlace& place, Feedback feedback, std::string answer) {
    StepProgress& step = progress.of(place.lesson->id, place.step);
    ++step.tries;
    step.answer = std::move(answer);
    answered_right_ = feedback.right;
    if (feedback.right && !state_checks_hold(w, place.content()))
        feedback = {"That is right; now do what the step asks for in the window.", false};
    feedback_ = std::move(feedback);
    ++changes_;
}

void LessonWork::answer_typed(const Workspace& w, const StepPlace& place) {
    const LessonStep& step = place.content();
    try {
        if (const auto* number = check_of<NumberCheck>(step.checks))
            judge(w, place, judged_number(*number, typed, w), typed);
        else if (const auto* text = check_of<TextCheck>(step.checks))
            judge(w, place, judged_text(*text, typed), typed);
    } catch (const Error& error) {
        feedback_ = {error.what(), false};
    }
}

void LessonWork::answer_chosen(const Workspace& w, const StepPlace& place, std::size_t option) {
    const auto* choice = check_of<ChoiceCheck>(place.content().checks);
    if (choice == nullptr || option >= choice->options.size()) return;
    const ChoiceCheck::Option& chosen = choice->options[option];
    if (chosen.cause.empty()) return judge(w, place, {chosen.why, chosen.right}, chosen.text);
    const bool right = cause_.starts_with(chosen.cause);
    judge(w, place, {right ? verdict_ : chosen.why, right}, chosen.text);
}

void LessonWork::reset() {
    progress = {};
    feedback_ = {};
    typed.clear();
    answered_right_ = false;
    ++changes_;
}

}  // namespace momentscope::ui
