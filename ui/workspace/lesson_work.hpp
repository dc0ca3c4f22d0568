// lesson_work.hpp -- the open step while a student works on it: what they typed, what is said about it, and
// what they have done.
#pragma once
#include <string>

#include "ui/model/course.hpp"
#include "ui/model/progress.hpp"

namespace momentscope::ui {

struct Workspace;

/// Checks are made against what the window shows.
class LessonWork {
public:
    Progress progress;
    std::string typed;  // in the field of the open step

    /// What is said about the last answer; "" if nothing was answered.
    struct Feedback {
        std::string sentence;
        bool right = false;
    };
    const Feedback& feedback() const { return feedback_; }

    /// Call this once per frame, after the update of the window: forgets what was typed when another step
    /// opens, and notes a step as done whose checks hold.
    void update(const Workspace& workspace, const std::optional<StepPlace>& open);

    /// Checks an answer of the open step.
    void answer_typed(const Workspace& workspace, const StepPlace& place);
    void answer_chosen(const Workspace& workspace, const StepPlace& place, std::size_t option);

    /// Changes whenever the progress changes.
    long changes() const { return changes_; }

    /// Has the progress changed since the card was drawn?
    bool has_changed() const { return changed_; }
    void reset();

private:
    void judge(const Workspace& workspace, const StepPlace& place, Feedback feedback, std::string answer);

    std::string lesson_;
    std::size_t step_ = 0;
    Feedback feedback_;
    // The greatest cause of the error and the verdict as the step began; what the student changes does not
    // change what is right.
    std::string cause_, verdict_;
    bool answered_right_ = false;
    long changes_ = 0;
    bool changed_ = false;
};

/// Do all checks of the state and of measures of the step hold now?
bool state_checks_hold(const Workspace& workspace, const LessonStep& step);

/// Does the open step hide this (a tab by its key, or VERDICT)? Nothing is hidden once the step is done or
/// its answer is shown.
bool is_hidden(const Workspace& workspace, std::string_view what);

/// Does the step ask for an answer that is typed, chosen or written?
bool asks_answer(const LessonStep& step);

}  // namespace momentscope::ui
