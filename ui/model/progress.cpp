#include "ui/model/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/support/bounded_json.hpp"
#include "core/support/error.hpp"
#include "core/support/markup.hpp"
#include "ui/model/glossary.hpp"
#include "ui/model/json_reader.hpp"
#include "ui/model/lesson_file.hpp"

namespace momentscope::ui {

namespace {

constexpr int PROGRESS_VERSION = 1;

const char* state_text(const LessonStep& step, const StepProgress& progress) {
    if (step.checks.empty()) return "read";
    return progress.done ? "done" : progress.tries > 0 ? "not right yet" : "not tried";
}

}  // namespace

const StepProgress& Progress::of(const std::string& lesson, std::size_t step) const {
    static const StepProgress nothing;
    const auto found = lessons_.find(lesson);
    return found == lessons_.end() || step >= found->second.size() ? nothing : found->second[step];
}

StepProgress& Progress::of(const std::string& lesson, std::size_t step) {
    std::vector<StepProgress>& steps = lessons_[lesson];
    if (step >= steps.size()) steps.resize(step + 1);
    return steps[step];
}

bool Progress::is_done(const Lesson& lesson) const {
    for (std::size_t i = 0; i < lesson.steps.size(); ++i)
        if (!lesson.steps[i].checks.empty() && !of(lesson.id, i).done) return false;
    return true;
}

nlohmann::ordered_json progress_to_json(const Progress& progress) {
    nlohmann::ordered_json lessons = nlohmann::ordered_json::object();
    for (const auto& [id, steps] : progress.lessons_) {
        nlohmann::ordered_json list = nlohmann::ordered_json::array();
        for (const StepProgress& step : steps)
            list.push_back({{"done", step.done}, {"tries", step.tries}, {"answer", step.answer}});
        lessons[id] = list;
    }
    return {{"momentscope_progress", PROGRESS_VERSION}, {"lessons", lessons}};
}

Progress progress_from_json(const std::string& text) {
    const nlohmann::json root = parse_bounded_json(text, {.bytes = MAX_PROGRESS_BYTES});
    Progress progress;
    std::vector<std::string> ignored;  // keys of later versions
    JsonReader reader(root, "", ignored, "progress");
    reader.version("momentscope_progress", PROGRESS_VERSION);
    const nlohmann::json* lessons = reader.find("lessons");
    if (lessons == nullptr || !lessons->is_object()) reader.fail("lessons", "an object");
    for (const auto& item : lessons->items()) {
        if (!item.value().is_array() || item.value().size() > MAX_LESSON_STEPS)
            reader.fail("lessons", "lists of steps");
        for (const nlohmann::json& entry : item.value()) {
            JsonReader step_reader(entry, "lessons.", ignored, "progress");
            StepProgress step;
            step_reader.flag("done", step.done);
            float tries = 0;
            step_reader.number("tries", tries, 0, 1e6f);
            step.tries = static_cast<int>(tries);
            step_reader.text("answer", step.answer);
            progress.lessons_[item.key()].push_back(std::move(step));
        }
    }
    return progress;
}

std::string answers_text(std::span<const Lesson> lessons, const Progress& progress) {
    std::string text = "# Answers\n";
    for (const Lesson& lesson : lessons) {
        if (!progress.lessons_.contains(lesson.id)) continue;
        text += fmt::format("\n## {}{}\n\n", lesson.title, progress.is_done(lesson) ? " (done)" : "");
        for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
            const LessonStep& step = lesson.steps[i];
            const StepProgress& done = progress.of(lesson.id, i);
            const std::string asked = without_marks(step.question.empty() ? step.action : step.question);
            text += fmt::format("{}. {}\n   *{}{}*", i + 1, markdown_cell(asked), state_text(step, done),
                                done.tries > 1 ? fmt::format(", {} tries", done.tries) : "");
            text += done.answer.empty() ? "\n" : fmt::format(": {}\n", markdown_cell(done.answer));
        }
    }
    return text;
}

}  // namespace momentscope::ui
