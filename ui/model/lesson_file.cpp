#include "ui/model/lesson_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/scene/scenes.hpp"
#include "core/support/bounded_json.hpp"
#include "core/support/error.hpp"
#include "core/support/input_file.hpp"
#include "core/support/plain_text.hpp"
#include "ui/model/glossary.hpp"
#include "ui/model/lesson_checks.hpp"
#include "ui/model/lesson_keys.hpp"
#include "ui/model/panel_list.hpp"
#include "ui/model/session.hpp"

namespace momentscope::ui {

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

Attempt attempt_from(const json& object, const std::string& where) {
    LessonKeys keys(object, where);
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
    LessonKeys keys(object, where);
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
    for (const Check& check : step.checks) {
        const auto* state = std::get_if<StateCheck>(&check);
        if (state != nullptr && (state->pointer.empty() || !session_value(solved, state->pointer)))
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
    LessonKeys keys(root, "");
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
