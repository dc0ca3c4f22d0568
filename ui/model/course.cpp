#include "ui/model/course.hpp"

#include <algorithm>

#include "core/support/error.hpp"
#include "ui/model/embedded_texts.hpp"
#include "ui/model/lesson_file.hpp"

namespace momentscope::ui {

const std::vector<Lesson>& own_lessons() {
    static const std::vector<Lesson> lessons = [] {
        std::vector<Lesson> read;
        for (const auto& [name, text] : embedded_lessons())
            read.push_back(lesson_from_json(std::string(text), std::string(name)));
        return read;
    }();
    return lessons;
}

const Lesson* Course::find(std::string_view id) const {
    const auto found = std::ranges::find(lessons_, id, &Lesson::id);
    return found == lessons_.end() ? nullptr : &*found;
}

Course::Added Course::add(const std::filesystem::path& file_or_folder) {
    LessonFolder read = read_lessons(file_or_folder);
    Added added = {.problems = std::move(read.problems)};
    std::string first;
    for (Lesson& lesson : read.lessons) {
        if (first.empty()) first = lesson.id;
        const auto same = std::ranges::find(lessons_, lesson.id, &Lesson::id);
        if (same == lessons_.end())
            lessons_.push_back(std::move(lesson));
        else
            *same = std::move(lesson);
    }
    if (first.empty() && !added.problems.empty()) throw Error(added.problems.front());
    added.first = find(first);
    return added;
}

std::optional<StepPlace> Course::open_step(const ExplorerState& state) const {
    const Lesson* lesson = find(state.card);
    if (lesson == nullptr) return std::nullopt;
    return StepPlace{lesson, std::min(state.step, lesson->steps.size() - 1)};
}

std::optional<StepPlace> Course::next(const StepPlace& place) const {
    if (place.step + 1 < place.lesson->steps.size()) return StepPlace{place.lesson, place.step + 1};
    const auto index = static_cast<std::size_t>(place.lesson - lessons_.data());
    if (index + 1 == lessons_.size()) return std::nullopt;
    return StepPlace{&lessons_[index + 1], 0};
}

std::optional<StepPlace> Course::previous(const StepPlace& place) const {
    if (place.step > 0) return StepPlace{place.lesson, place.step - 1};
    const auto index = static_cast<std::size_t>(place.lesson - lessons_.data());
    if (index == 0) return std::nullopt;
    const Lesson& before = lessons_[index - 1];
    return StepPlace{&before, before.steps.size() - 1};
}

void open_lesson(ExplorerState& state, const Lesson& lesson) {
    go_to(state, {&lesson, 0}, false);
}

void go_forward(ExplorerState& state, const StepPlace& next) {
    if (next.step == 0) return go_to(state, next, false);
    state = changed_state(state, next.content().session);
    state.step = next.step;
    state.hint = state.answer = false;
}

void go_to(ExplorerState& state, const StepPlace& place, bool solved) {
    state = lesson_state(*place.lesson, place.step, solved, state);
    state.answer = solved;
}

bool highlights(const Lesson& lesson, std::string_view control) {
    return std::ranges::any_of(lesson.steps, [&](const LessonStep& step) {
        return std::ranges::find(step.highlight, control) != step.highlight.end();
    });
}

bool hides(const LessonStep& step, std::string_view what) {
    return std::ranges::find(step.hide, what) != step.hide.end();
}

}  // namespace momentscope::ui
