#include "ui/model/lesson_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "core/inspect/error_causes.hpp"
#include "core/scene/scenes.hpp"
#include "core/support/bounded_json.hpp"
#include "core/support/error.hpp"
#include "core/support/input_file.hpp"
#include "core/support/plain_text.hpp"
#include "ui/model/glossary.hpp"
#include "ui/model/panel_list.hpp"
#include "ui/model/session.hpp"

namespace momentscope::ui {

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

// An object of a lesson, whose keys are taken one by one. `where`: such as "step 2: ".
class Keys {
public:
    Keys(const json& object, std::string where) : object_(object), where_(std::move(where)) {
        if (!object.is_object()) throw Error(where_ + "it must be an object.");
    }
    const json* take(const char* key) {
        taken_.emplace_back(key);
        const auto found = object_.find(key);
        return found == object_.end() ? nullptr : &*found;
    }
    // One paragraph, or a list of paragraphs.
    std::string text(const char* key) {
        const json* found = take(key);
        if (found == nullptr) return "";
        if (found->is_string()) return found->get<std::string>();
        std::string joined;
        const auto is_text = [](const json& entry) { return entry.is_string(); };
        if (!found->is_array() || !std::ranges::all_of(*found, is_text))
            fail(key, "a text or a list of texts");
        for (const json& entry : *found) joined += (joined.empty() ? "" : "\n\n") + entry.get<std::string>();
        return joined;
    }
    std::vector<std::string> texts(const char* key) {
        const json* found = take(key);
        if (found == nullptr) return {};
        const auto is_text = [](const json& entry) { return entry.is_string(); };
        if (!found->is_array() || !std::ranges::all_of(*found, is_text)) fail(key, "a list of texts");
        return found->get<std::vector<std::string>>();
    }
    json object(const char* key) {
        const json* found = take(key);
        if (found == nullptr) return json::object();
        if (!found->is_object()) fail(key, "an object");
        return *found;
    }
    std::optional<double> number(const char* key) {
        const json* found = take(key);
        if (found == nullptr) return std::nullopt;
        if (!found->is_number()) fail(key, "a number");
        return found->get<double>();
    }
    std::optional<std::size_t> count(const char* key, std::size_t most) {
        const json* found = take(key);
        if (found == nullptr) return std::nullopt;
        if (!found->is_number_unsigned() || found->get<std::size_t>() < 1 || found->get<std::size_t>() > most)
            fail(key, fmt::format("a whole number from 1 to {}", most));
        return found->get<std::size_t>();
    }
    bool flag(const char* key) {
        const json* found = take(key);
        if (found == nullptr) return false;
        if (!found->is_boolean()) fail(key, "true or false");
        return found->get<bool>();
    }
    // Call this last.
    void require_known() const {
        for (const auto& item : object_.items())
            if (std::ranges::find(taken_, item.key()) == taken_.end())
                throw Error(fmt::format("{}there is no key \"{}\" here; it may have {}.", where_,
                                        one_line(item.key().substr(0, 60)), fmt::join(taken_, ", ")));
    }
    [[noreturn]] void fail(const char* key, const std::string& what) const {
        throw Error(fmt::format("{}\"{}\" must be {}.", where_, key, what));
    }
    const std::string& where() const { return where_; }

private:
    const json& object_;
    std::string where_;
    std::vector<std::string> taken_;
};

MeasureId measure_from(const Keys& keys, const json& value, const char* key) {
    const std::string name = value.is_string() ? value.get<std::string>() : "";
    const auto row =
        std::ranges::find(MEASURES, name, [](const MeasureRow& r) { return std::string_view(r.key); });
    if (row != MEASURES.end()) return row->id;
    std::vector<std::string_view> names;
    for (const MeasureRow& r : MEASURES) names.emplace_back(r.key);
    keys.fail(key, fmt::format("one of {}", fmt::join(names, ", ")));
}

Limits any_limits_from(Keys& keys) {
    Limits limits = {
        .is = keys.number("is"), .at_least = keys.number("at_least"), .at_most = keys.number("at_most")};
    limits.within = keys.number("within").value_or(1e-6);
    return limits;
}

Limits limits_from(Keys& keys) {
    const Limits limits = any_limits_from(keys);
    if (!limits.is && !limits.at_least && !limits.at_most)
        throw Error(keys.where() + "a check of a number needs \"is\", \"at_least\" or \"at_most\".");
    return limits;
}

Check state_check(Keys& keys, const json& pointer) {
    StateCheck check;
    check.pointer = pointer.is_string() ? pointer.get<std::string>() : "";
    const json* is = keys.take("is");
    if (is != nullptr && !is->is_number()) {
        check.equals = *is;
        if (is->is_null()) keys.fail("is", "a value");
    } else {
        check.limits = limits_from(keys);
    }
    return check;
}

Check number_check(Keys& keys, const json& measure) {
    const auto within = keys.number("within");
    if (!within || !(*within > 0)) keys.fail("within", "a number above 0: how far the typed one may be off");
    NumberCheck check = {measure_from(keys, measure, "number"), *within};
    const json* mistakes = keys.take("mistakes");
    if (mistakes != nullptr && !mistakes->is_array()) keys.fail("mistakes", "a list");
    for (const json& entry : mistakes == nullptr ? json::array() : *mistakes) {
        Keys mistake(entry, keys.where() + "a mistake: ");
        const auto number = mistake.number("is");
        check.mistakes.push_back({number.value_or(0), mistake.text("why")});
        if (!number) mistake.fail("is", "a number");
        if (check.mistakes.back().why.empty()) mistake.fail("why", "what is said about it");
        mistake.require_known();
    }
    return check;
}

bool is_cause(std::string_view text) {
    return std::ranges::any_of(cause::ALL, [&](std::string_view one) { return one.starts_with(text); });
}

Check choice_check(Keys& keys, const json& options) {
    constexpr std::size_t MOST = 8;
    if (!options.is_array() || options.size() < 2 || options.size() > MOST)
        keys.fail("choice", fmt::format("a list of 2 to {} options", MOST));
    ChoiceCheck check;
    for (const json& entry : options) {
        Keys option(entry, keys.where() + "an option: ");
        check.options.push_back(
            {option.text("text"), option.text("why"), option.flag("right"), option.text("cause")});
        option.require_known();
        if (check.options.back().text.empty()) option.fail("text", "the text of the option");
        if (check.options.back().why.empty()) option.fail("why", "what is said if this is chosen");
    }
    for (const auto& option : check.options)
        if (!option.cause.empty() && !is_cause(option.cause))
            keys.fail("cause", fmt::format("the begin of one of: {}", fmt::join(cause::ALL, ", ")));
    const bool causes =
        std::ranges::none_of(check.options, [](const auto& option) { return option.cause.empty(); });
    if (!causes && std::ranges::count_if(check.options, &ChoiceCheck::Option::right) != 1)
        keys.fail("choice", "options of which exactly one is \"right\", or which all have a \"cause\"");
    return check;
}

Check text_check(Keys& keys, const json& words) {
    if (!words.is_number_unsigned() || words.get<std::size_t>() < 1 || words.get<std::size_t>() > 1000)
        keys.fail("text", "the least number of words, from 1 to 1000");
    return TextCheck{words.get<std::size_t>()};
}

// The kinds of checks. The key of a kind names what is checked.
struct CheckKind {
    const char* key;
    Check (*read)(Keys& keys, const json& value);
};
constexpr CheckKind CHECK_KINDS[] = {
    {"state", state_check},
    {"measure",
     [](Keys& keys, const json& value) -> Check {
         return MeasureCheck{measure_from(keys, value, "measure"), any_limits_from(keys)};
     }},
    {"number", number_check},
    {"choice", choice_check},
    {"text", text_check},
};

Check check_from(const json& object, const std::string& where) {
    Keys keys(object, where + "a check: ");
    const auto is_named = [&](const CheckKind& kind) { return object.contains(kind.key); };
    const auto kind = std::ranges::find_if(CHECK_KINDS, is_named);
    if (kind == std::end(CHECK_KINDS))
        throw Error(keys.where() +
                    "it names nothing; it needs one of state, measure, number, choice and text.");
    if (std::ranges::count_if(CHECK_KINDS, is_named) > 1)
        throw Error(keys.where() + "it names two kinds; make a list of two checks.");
    Check check = kind->read(keys, *keys.take(kind->key));
    keys.require_known();
    return check;
}

std::vector<Check> checks_from(const json* value, const std::string& where) {
    std::vector<Check> checks;
    if (value == nullptr) return checks;
    if (!value->is_array()) return {check_from(*value, where)};
    for (const json& entry : *value) checks.push_back(check_from(entry, where));
    const auto asks = [](const Check& check) {
        return !std::holds_alternative<StateCheck>(check) && !std::holds_alternative<MeasureCheck>(check);
    };
    if (std::ranges::count_if(checks, asks) > 1)
        throw Error(where + "only one check of a step can ask for an answer; make two steps.");
    return checks;
}

Attempt attempt_from(const json& object, const std::string& where) {
    Keys keys(object, where);
    Attempt attempt = {keys.object("session"), keys.text("type"), std::nullopt};
    if (const auto chosen = keys.count("choose", 8)) attempt.chosen = *chosen - 1;
    keys.require_known();
    return attempt;
}

// An attempt must answer what is asked.
void require_answer(const LessonStep& step, const Attempt& attempt, const std::string& where) {
    const auto* choice = check_of<ChoiceCheck>(step.checks);
    const bool types =
        check_of<NumberCheck>(step.checks) != nullptr || check_of<TextCheck>(step.checks) != nullptr;
    if (attempt.chosen && choice == nullptr)
        throw Error(where + "it has \"choose\", but the step has no choice.");
    if (attempt.chosen && *attempt.chosen >= choice->options.size())
        throw Error(fmt::format("{}\"choose\" is {}, but there are {} options.", where, *attempt.chosen + 1,
                                choice->options.size()));
    if (!attempt.typed.empty() && !types)
        throw Error(where + "it has \"type\", but the step asks for no number and no text.");
}

void require_terms(const std::string& text, const std::string& where) {
    for (const std::string& term : terms_of(text))
        if (find_term(term) == nullptr)
            throw Error(fmt::format("{}the glossary has no term '{}'.", where, one_line(term)));
}

LessonStep step_from(const json& object, const std::string& where) {
    Keys keys(object, where);
    LessonStep step;
    step.action = keys.text("do");
    step.question = keys.text("question");
    step.hint = keys.text("hint");
    step.answer = keys.text("answer");
    for (const std::string* text : {&step.action, &step.question, &step.hint, &step.answer})
        require_terms(*text, where);
    if (step.action.empty() && step.question.empty()) throw Error(where + "it needs \"do\" or \"question\".");
    step.session = keys.object("session");
    step.hide = keys.texts("hide");
    for (const std::string& name : step.hide)
        if (name != VERDICT && std::ranges::find(PANELS, name, &PanelRow::key) == PANELS.end())
            keys.fail("hide", "a list of \"verdict\" and keys of tabs, such as \"technique\"");
    step.highlight = keys.texts("highlight");
    step.checks = checks_from(keys.take("check"), where);
    if (const json* solution = keys.take("solution"))
        step.solution = attempt_from(*solution, where + "the solution: ");
    if (const json* wrong = keys.take("wrong")) {
        if (!wrong->is_array()) keys.fail("wrong", "a list of attempts");
        for (const json& entry : *wrong)
            step.wrong.push_back(attempt_from(entry, where + "a wrong answer: "));
    }
    keys.require_known();
    require_answer(step, step.solution, where + "the solution: ");
    for (const Attempt& attempt : step.wrong) require_answer(step, attempt, where + "a wrong answer: ");
    if (!step.checks.empty() && !object.contains("solution"))
        throw Error(where + "it has a check, so it needs a \"solution\" that passes.");
    return step;
}

// The scenes of a session beside the file of the lesson.
void find_scene(json& session, const fs::path& file) {
    const auto scene = session.find("scene");
    if (scene == session.end() || !scene->is_string()) return;
    *scene = scene_beside(scene->get<std::string>(), file);
}

void find_scenes(Lesson& lesson, const fs::path& file) {
    find_scene(lesson.session, file);
    for (LessonStep& step : lesson.steps) {
        find_scene(step.session, file);
        find_scene(step.solution.session, file);
        for (Attempt& attempt : step.wrong) find_scene(attempt.session, file);
    }
}

void require_scene(const ExplorerState& state) {
    std::error_code code;
    if (!state.ray && !is_builtin_scene(state.scene) && !fs::exists(state.scene, code))
        throw Error(
            fmt::format("it needs the scene '{}', which is neither built in nor a file beside the lesson.",
                        one_line(state.scene)));
}

// A state check must name something that the session has when the step is solved.
void require_pointers(const LessonStep& step, const ExplorerState& solved) {
    const json session = json::parse(session_to_json(solved).dump());
    for (const Check& check : step.checks) {
        const auto* state = std::get_if<StateCheck>(&check);
        if (state == nullptr) continue;
        bool exists = false;
        try {
            exists = !state->pointer.empty() && session.contains(json::json_pointer(state->pointer));
        } catch (const json::exception&) {
            exists = false;  // it is no pointer
        }
        if (!exists)
            throw Error(fmt::format(
                "a session has no '{}'; \"state\" must be a JSON pointer, such as /parameters/beta.",
                one_line(state->pointer)));
    }
}

// Every state that the lesson can set.
void require_states(const Lesson& lesson) {
    const auto at = [](const std::string& where, const auto& require) {
        try {
            require();
        } catch (const Error& error) {
            throw Error(fmt::format("{}: {}", where, error.what()));
        }
    };
    at("the session", [&] {
        Lesson alone = lesson;
        alone.steps = {LessonStep()};
        require_scene(lesson_state(alone, 0, false, {}));
    });
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const std::string step = fmt::format("step {}", i + 1);
        ExplorerState start;
        at(step, [&] { require_scene(start = lesson_state(lesson, i, false, {})); });
        at(step + ": the solution", [&] {
            const ExplorerState solved = lesson_state(lesson, i, true, {});
            require_scene(solved);
            require_pointers(lesson.steps[i], solved);
        });
        for (const Attempt& attempt : lesson.steps[i].wrong)
            at(step + ": a wrong answer", [&] { require_scene(changed_state(start, attempt.session)); });
    }
}

Lesson lesson_from_object(const json& root, const fs::path& file) {
    Keys keys(root, "");
    const json* version = keys.take("momentscope_lesson");
    if (version == nullptr || !version->is_number_integer())
        throw Error("it is not a lesson; docs/lessons.md says what a lesson is.");
    if (*version != LESSON_VERSION)
        throw Error(fmt::format("it has version {}, but this Momentscope reads version {}.", version->dump(),
                                LESSON_VERSION));
    Lesson lesson;
    lesson.id = keys.text("id");
    const auto is_plain = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
    if (lesson.id.empty() || lesson.id.size() > 40 || !std::ranges::all_of(lesson.id, is_plain))
        keys.fail("id", "a name of at most 40 small letters, digits and hyphens");
    lesson.title = keys.text("title");
    constexpr std::size_t MOST_TITLE = 80;
    if (lesson.title.empty() || lesson.title.size() > MOST_TITLE || one_line(lesson.title) != lesson.title)
        keys.fail("title", fmt::format("a line of at most {} characters", MOST_TITLE));
    lesson.text = keys.text("text");
    require_terms(lesson.text, "the text: ");
    lesson.session = keys.object("session");
    lesson.all_controls = keys.flag("all_controls");
    const json* steps = keys.take("steps");
    if (steps == nullptr || !steps->is_array() || steps->empty() || steps->size() > MAX_LESSON_STEPS)
        keys.fail("steps", fmt::format("a list of 1 to {} steps", MAX_LESSON_STEPS));
    for (std::size_t i = 0; i < steps->size(); ++i)
        lesson.steps.push_back(step_from((*steps)[i], fmt::format("step {}: ", i + 1)));
    keys.require_known();
    find_scenes(lesson, file);
    require_states(lesson);
    return lesson;
}

}  // namespace

Lesson lesson_from_json(const std::string& text, const std::string& file) {
    try {
        Lesson lesson = lesson_from_object(parse_bounded_json(text, {.bytes = MAX_LESSON_BYTES}), file);
        lesson.file = file;
        return lesson;
    } catch (const Error& error) {
        throw Error(fmt::format("The lesson '{}' cannot be read: {}", file, error.what()));
    }
}

Lesson read_lesson_file(const fs::path& path) {
    return lesson_from_json(read_input_file(path, MAX_LESSON_BYTES, "lesson"), path.string());
}

LessonFolder read_lessons(const fs::path& file_or_folder) {
    std::error_code code;
    if (!fs::is_directory(file_or_folder, code)) return {{read_lesson_file(file_or_folder)}, {}};
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(file_or_folder, code))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::ranges::sort(files);
    if (files.empty())
        throw Error(fmt::format("The folder '{}' has no lessons, which are .json files; choose another one.",
                                file_or_folder.string()));
    LessonFolder folder;
    for (const fs::path& file : files) {
        try {
            Lesson lesson = read_lesson_file(file);
            const auto same = std::ranges::find(folder.lessons, lesson.id, &Lesson::id);
            if (same != folder.lessons.end())
                throw Error(fmt::format("The lesson '{}' has the id '{}' of '{}'; give it another one.",
                                        file.string(), lesson.id, same->file));
            folder.lessons.push_back(std::move(lesson));
        } catch (const Error& error) {
            folder.problems.emplace_back(error.what());
        }
    }
    return folder;
}

}  // namespace momentscope::ui
