// course.hpp -- the lessons that the window offers: its own, and those that the user opened.
#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ui/model/lesson.hpp"

namespace momentscope::ui {

/// The lessons that the program carries with it, in the order of their files.
const std::vector<Lesson>& own_lessons();

/// A step of a course, and its place in the order of all steps.
struct StepPlace {
    const Lesson* lesson = nullptr;
    std::size_t step = 0;
    const LessonStep& content() const { return lesson->steps[step]; }
};

class Course {
public:
    Course() : lessons_(own_lessons()) {}
    explicit Course(std::vector<Lesson> lessons) : lessons_(std::move(lessons)) {}

    std::span<const Lesson> lessons() const { return lessons_; }
    const Lesson* find(std::string_view id) const;  // nullptr if there is none

    /// Adds the lessons of a file or a folder behind the others; one with an id that is there already takes
    /// its place. Returns the first of them, or nullptr, and what was wrong. Throws Error if nothing could be
    /// read.
    struct Added {
        const Lesson* first = nullptr;
        std::vector<std::string> problems;
    };
    Added add(const std::filesystem::path& file_or_folder);

    /// The open step; nullopt if no lesson is open.
    std::optional<StepPlace> open_step(const ExplorerState& state) const;

    /// The place behind or before a step, also in the next or last lesson; nullopt at the ends of the course.
    std::optional<StepPlace> next(const StepPlace& place) const;
    std::optional<StepPlace> previous(const StepPlace& place) const;

private:
    std::vector<Lesson> lessons_;
};

/// Opens a lesson at its first step in a fresh state. Theme and layout stay.
void open_lesson(ExplorerState& state, const Lesson& lesson);

/// Goes to the next step of the open lesson: the user's state, with the changes of that step.
void go_forward(ExplorerState& state, const StepPlace& next);

/// Goes to the start of any step, or to its end with the answer.
void go_to(ExplorerState& state, const StepPlace& place, bool solved);

/// Does any step of the lesson highlight this control?
bool highlights(const Lesson& lesson, std::string_view control);

/// Does the step hide this?
bool hides(const LessonStep& step, std::string_view what);

}  // namespace momentscope::ui
