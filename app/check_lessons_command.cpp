#include <fmt/format.h>

#include "app/command.hpp"
#include "app/headless_window.hpp"
#include "app/options.hpp"
#include "app/terminal.hpp"
#include "core/support/error.hpp"
#include "core/support/json_text.hpp"
#include "ui/model/course.hpp"
#include "ui/model/lesson_file.hpp"
#include "ui/model/selection.hpp"
#include "ui/model/session.hpp"
#include "ui/workspace/lesson_work.hpp"
#include "ui/workspace/measures.hpp"

namespace momentscope {

namespace {

constexpr glm::ivec2 WINDOW_SIZE = {960, 600};

// Replays the steps of lessons in a window without a display, as a student would take them.
class Replay {
public:
    explicit Replay(ui::Course course)
        : window_(WINDOW_SIZE, {}, {.show_times = false, .settings = ui::NEW_USER}, log_) {
        workspace().course = std::move(course);
    }

    /// What is wrong with a step; empty if it is right.
    std::vector<std::string> problems_of(const ui::StepPlace& place) {
        const ui::LessonStep& step = place.content();
        std::vector<std::string> problems;
        start(place);
        for (const std::string& control : step.highlight)
            if (!workspace().widget_rects.contains(control))
                problems.push_back(fmt::format("the window has no control '{}' to highlight", control));
        if (step.checks.empty()) return problems;
        if (is_done(place)) problems.emplace_back("its check passes before anything was done");
        for (const ui::Attempt& attempt : wrong_attempts(step)) {
            if (is_changed(place)) start(place);
            if (passes(place, attempt))
                problems.push_back(
                    fmt::format("its check passes with the wrong answer {}", text_of(attempt)));
        }
        if (is_changed(place)) start(place);
        if (!passes(place, step.solution))
            problems.push_back("its check fails with the solution" + why(step));
        return problems;
    }

    /// The given wrong answers, and every option of a choice but that of the solution.
    static std::vector<ui::Attempt> wrong_attempts(const ui::LessonStep& step) {
        std::vector<ui::Attempt> attempts = step.wrong;
        for (const ui::Check& check : step.checks)
            if (const auto* choice = std::get_if<ui::ChoiceCheck>(&check))
                for (std::size_t i = 0; i < choice->options.size(); ++i)
                    if (step.solution.chosen != i) attempts.push_back({step.solution.session, "", i});
        return attempts;
    }

private:
    ui::Workspace& workspace() { return window_.explorer().workspace(); }

    static std::string text_of(const ui::Attempt& attempt) {
        if (attempt.chosen) return std::string(1, static_cast<char>('A' + *attempt.chosen));
        return attempt.typed.empty() ? attempt.session.dump() : attempt.typed;
    }

    // What the window measures.
    std::string why(const ui::LessonStep& step) {
        std::string text;
        for (const ui::Check& check : step.checks) {
            if (const auto* state = std::get_if<ui::StateCheck>(&check)) {
                const auto value = ui::session_value(workspace().state, state->pointer);
                text += fmt::format("; {} is {}", state->pointer, value ? json_text(*value) : "not there");
            }
            const auto* measure = std::get_if<ui::MeasureCheck>(&check);
            const auto* number = std::get_if<ui::NumberCheck>(&check);
            if (measure == nullptr && number == nullptr) continue;
            const ui::MeasureId id = measure != nullptr ? measure->measure : number->measure;
            const auto value = ui::measured(id, workspace());
            text += fmt::format("; {} is {}", ui::MEASURES[static_cast<std::size_t>(id)].key,
                                value ? fmt::format("{:.6g}", *value) : "not known");
        }
        return text;
    }

    bool is_done(const ui::StepPlace& place) {
        return std::as_const(workspace().lesson.progress).of(place.lesson->id, place.step).done;
    }

    // An answer alone changes nothing but the progress.
    bool is_changed(const ui::StepPlace& place) {
        const ui::ExplorerState& state = workspace().state;
        return is_done(place) || !(state == ui::lesson_state(*place.lesson, place.step, false, state));
    }

    void start(const ui::StepPlace& place) {
        ui::close_card(workspace().state);
        window_.settle();
        workspace().lesson.reset();
        ui::go_to(workspace().state, place, false);
        window_.settle();
    }

    bool passes(const ui::StepPlace& place, const ui::Attempt& attempt) {
        ui::Workspace& w = workspace();
        w.state = ui::changed_state(w.state, attempt.session);
        window_.settle();
        if (!attempt.typed.empty()) {
            w.lesson.typed = attempt.typed;
            w.lesson.answer_typed(w, place);
        }
        if (attempt.chosen) w.lesson.answer_chosen(w, place, *attempt.chosen);
        window_.settle();
        return is_done(place);
    }

    FrameLog log_{""};
    HeadlessWindow window_;
};

class CheckLessons : public ParsedCommand {
public:
    explicit CheckLessons(CLI::App& app) : ParsedCommand(app) {
        app.add_option("lessons", path_, "a lesson file, or a folder of them [the lessons of the program]");
        add_gl(app);
    }

    FileUse files() const override {
        return {path_.empty() ? std::vector<std::string>() : std::vector{path_}, {}};
    }

    void run() const override {
        ui::Course course;
        std::size_t problems = 0;
        if (!path_.empty()) {
            ui::LessonFolder folder = ui::read_lessons(path_);
            for (const std::string& problem : folder.problems) warn(problem);
            problems += folder.problems.size();
            course = ui::Course(std::move(folder.lessons));
        }
        Replay replay(course);
        for (const ui::Lesson& lesson : course.lessons())
            for (std::size_t i = 0; i < lesson.steps.size(); ++i)
                problems += report({&lesson, i}, replay.problems_of({&lesson, i}));
        if (problems > 0)
            throw Error(
                fmt::format("{} found in the lessons; {} named above.",
                            problems == 1 ? "One problem was" : fmt::format("{} problems were", problems),
                            problems == 1 ? "it is" : "they are"));
        const std::size_t count = course.lessons().size();
        print(count == 1 ? "The lesson is right.\n" : fmt::format("All {} lessons are right.\n", count));
    }

private:
    static std::string wrong_text(std::size_t count) {
        return count == 1 ? "a wrong answer" : fmt::format("{} wrong answers", count);
    }

    // Prints the result of a step and returns the number of problems.
    static std::size_t report(const ui::StepPlace& place, const std::vector<std::string>& problems) {
        const std::string name = fmt::format("{} {}", place.lesson->id, place.step + 1);
        for (const std::string& problem : problems)
            warn(fmt::format("{}, step {}: {}.", place.lesson->file, place.step + 1, problem));
        if (problems.empty() && place.content().checks.empty())
            print(fmt::format("{}: nothing to check\n", name));
        else if (problems.empty())
            print(fmt::format("{}: passes with the solution, fails at the start and with {}\n", name,
                              wrong_text(Replay::wrong_attempts(place.content()).size())));
        return problems.size();
    }

    std::string path_;
};

}  // namespace

std::unique_ptr<ParsedCommand> add_check_lessons(CLI::App& app) {
    return std::make_unique<CheckLessons>(app);
}

}  // namespace momentscope
