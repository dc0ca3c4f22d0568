#include "ui/model/lesson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/support/error.hpp"
#include "core/support/json_text.hpp"
#include "core/support/parse_number.hpp"
#include "core/support/plain_text.hpp"
#include "ui/model/session.hpp"

namespace momentscope::ui {

namespace {

ExplorerState state_of_session(const nlohmann::json& session) {
    Session read = session_from_json(json_text(session));
    if (!read.ignored.empty())
        throw Error(fmt::format("A session has no \"{}\".", fmt::join(read.ignored, "\", \"")));
    return std::move(read.state);
}

}  // namespace

bool Limits::hold(double value) const {
    return std::isfinite(value) && (!is || std::abs(value - *is) <= within) &&
           (!at_least || value >= *at_least) && (!at_most || value <= *at_most);
}

ExplorerState lesson_state(const Lesson& lesson, std::size_t step, bool solved, const ExplorerState& now) {
    nlohmann::json session = {{"momentscope_session", SESSION_VERSION}};
    session.merge_patch(lesson.session);
    for (std::size_t i = 0; i <= step; ++i) {
        session.merge_patch(lesson.steps[i].session);
        if (i < step || solved) session.merge_patch(lesson.steps[i].solution.session);
    }
    ExplorerState state = state_of_session(session);
    state.theme = now.theme;
    state.scene_share = now.scene_share;
    state.plot_share = now.plot_share;
    state.card = lesson.id;
    state.step = step;
    return state;
}

ExplorerState changed_state(const ExplorerState& state, const nlohmann::json& changes) {
    nlohmann::json session(session_to_json(state));
    session.merge_patch(changes);
    return state_of_session(session);
}

std::optional<double> number_at(const std::string& pointer, const ExplorerState& state) {
    const auto value = session_value(state, pointer);
    return value && value->is_number() ? std::optional(value->get<double>()) : std::nullopt;
}

bool holds(const StateCheck& check, const ExplorerState& state) {
    if (!check.equals.is_null()) return session_value(state, check.pointer) == check.equals;
    const auto number = number_at(check.pointer, state);
    return number && check.limits.hold(*number);
}

bool measures(const LessonStep& step, MeasureId id) {
    return std::ranges::any_of(step.checks, [&](const Check& check) {
        const auto* measure = std::get_if<MeasureCheck>(&check);
        const auto* number = std::get_if<NumberCheck>(&check);
        const auto* choice = std::get_if<ChoiceCheck>(&check);
        if (choice != nullptr && id == MeasureId::color_error) return !choice->options.front().cause.empty();
        return (measure != nullptr && measure->measure == id) || (number != nullptr && number->measure == id);
    });
}

double typed_number(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(" \t");
    const std::size_t end = text.find_last_not_of(" \t");
    const std::string trimmed = begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
    std::string with_point = trimmed;
    std::ranges::replace(with_point, ',', '.');
    const auto number = parse_number<double>(with_point);
    if (!number || !std::isfinite(*number))
        throw Error(trimmed.empty() ? "Type a number, such as 0.25."
                                    : fmt::format("'{}' is not a number; type only digits, such as 0.25.",
                                                  one_line(trimmed.substr(0, 40))));
    return *number;
}

std::size_t word_count(const std::string& text) {
    std::istringstream stream(text);
    std::size_t count = 0;
    for (std::string word; stream >> word;) ++count;
    return count;
}

}  // namespace momentscope::ui
