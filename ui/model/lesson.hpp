// lesson.hpp -- a lesson: texts, states to start from, and checks of what the student did. Lessons are files
// (docs/lessons.md); lesson_file.hpp reads them.
#pragma once
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "ui/model/state.hpp"

namespace momentscope::ui {

enum class MeasureId {
#define MEASURE(id, name, digits, help) id,
#include "ui/model/measures.def"
#undef MEASURE
};

/// A number that the program computes.
struct MeasureRow {
    MeasureId id;
    const char* key;
    const char* name;  // on the card
    int digits;        // behind the point
    const char* help;
};
inline constexpr std::array MEASURES = {
#define MEASURE(id, name, digits, help) MeasureRow{MeasureId::id, #id, name, digits, help},
#include "ui/model/measures.def"
#undef MEASURE
};

constexpr const char* VERDICT = "verdict";  // what Fragments says about the error

/// What a number must be: near `is`, or not below or above a limit. Without any of them, anything.
struct Limits {
    std::optional<double> is, at_least, at_most;
    double within = 0;  // of `is`
    bool hold(double value) const;
};

/// A choice of the user has a value.
struct StateCheck {
    std::string pointer;    // into the session, such as "/parameters/beta"
    nlohmann::json equals;  // null if the value is a number with limits
    Limits limits;
};

/// A number of the program lies within limits.
struct MeasureCheck {
    MeasureId measure{};
    Limits limits;
};

/// The student types a number. The right one is measured when they do.
struct NumberCheck {
    /// A wrong number, and what is said about it.
    struct Mistake {
        double number = 0;
        std::string why;
    };
    MeasureId measure{};
    double within = 0;
    std::vector<Mistake> mistakes = {};
};

/// The student chooses one of several answers.
struct ChoiceCheck {
    struct Option {
        std::string text;
        std::string why;  // said if it is chosen
        bool right = false;
        std::string cause;  // right if the greatest cause of the pixel's error begins so; "": see `right`
    };
    std::vector<Option> options;
};

/// The student writes an answer, which is kept for the teacher.
struct TextCheck {
    std::size_t words = 0;  // at least so many
};

using Check = std::variant<StateCheck, MeasureCheck, NumberCheck, ChoiceCheck, TextCheck>;

/// The first check of this kind; nullptr if there is none.
template <typename Kind>
const Kind* check_of(const std::vector<Check>& checks) {
    for (const Check& check : checks)
        if (const auto* found = std::get_if<Kind>(&check)) return found;
    return nullptr;
}

/// What a student may do in a step: change the state, and type, choose or write an answer.
struct Attempt {
    nlohmann::json session = nlohmann::json::object();  // changes of the session, as a JSON merge patch
    std::string typed;                                  // for number and text
    std::optional<std::size_t> chosen;                  // index of an option
};

struct LessonStep {
    std::string action, question, hint, answer;         // texts with marks; "" if there is none
    nlohmann::json session = nlohmann::json::object();  // changes at the start of the step
    std::vector<std::string> hide;                      // until the step is done: VERDICT, or keys of tabs
    std::vector<std::string> highlight;                 // controls, by the names of event files
    std::vector<Check> checks;                          // all must hold; none: there is nothing to check
    Attempt solution;
    std::vector<Attempt> wrong;
};

struct Lesson {
    std::string id;
    std::string title;
    std::string text;  // with marks
    nlohmann::json session = nlohmann::json::object();
    bool all_controls = false;      // are experts' parameters shown, too?
    std::vector<LessonStep> steps;  // at least one
    std::string file;               // where it was read from, for messages
};

/// The state at the start of a step, or at its end: that of a fresh window, changed by the lesson, by the
/// steps before and by their solutions. Theme and layout are those of `now`. Throws Error if a change makes
/// no session.
ExplorerState lesson_state(const Lesson& lesson, std::size_t step, bool solved, const ExplorerState& now);

/// A state with changes (a JSON merge patch of its session). Throws Error if the result is not a session, or
/// if a key does not exist.
ExplorerState changed_state(const ExplorerState& state, const nlohmann::json& changes);

/// The number at a JSON pointer into the session of a state; nullopt if there is none.
std::optional<double> number_at(const std::string& pointer, const ExplorerState& state);

/// Does the state pass the check?
bool holds(const StateCheck& check, const ExplorerState& state);

/// Does a check of the step use this number?
bool measures(const LessonStep& step, MeasureId id);

/// The number of a typed text, with a decimal point or comma. Throws Error that says what is expected.
double typed_number(const std::string& text);

/// The number of words of a text.
std::size_t word_count(const std::string& text);

}  // namespace momentscope::ui
