#include "ui/workspace/presenting.hpp"

#include <utility>

namespace momentscope::ui {

namespace {

bool has_answer(const LessonStep& step) {
    return !step.answer.empty() || !step.solution.session.empty();
}

// Shows a state at once, or moves there.
void show(Workspace& w, ExplorerState to) {
    w.moving.reset();
    if (w.present && w.settings.moves)
        w.moving = Transition{w.state, std::move(to), w.state};
    else
        w.state = std::move(to);
}

void show_step(Workspace& w, const StepPlace& place, bool solved) {
    ExplorerState to = w.state;
    go_to(to, place, solved);
    show(w, std::move(to));
}

// Where the user is, or where the window is moving to.
const ExplorerState& goal(const Workspace& w) {
    return w.moving ? w.moving->to : w.state;
}

}  // namespace

void next_step(Workspace& w) {
    const auto place = w.course.open_step(goal(w));
    if (!place) return show_step(w, {&w.course.lessons().front(), 0}, false);
    if (w.present && !goal(w).answer && has_answer(place->content())) return show_step(w, *place, true);
    const auto next = w.course.next(*place);
    if (!next) return w.status.say("This is the last step of the last lesson.");
    if (w.present) return show_step(w, *next, false);
    go_forward(w.state, *next);
}

void previous_step(Workspace& w) {
    const auto place = w.course.open_step(goal(w));
    if (!place) return;
    if (w.present && goal(w).answer) return show_step(w, *place, false);
    const auto previous = w.course.previous(*place);
    if (!previous) return w.status.say("This is the first step of the first lesson.");
    show_step(w, *previous, w.present && has_answer(previous->content()));
}

void move_on(Workspace& w, float seconds) {
    if (!w.moving) return;
    if (!(w.state == w.moving->last)) return w.moving.reset();  // the user goes on from here
    w.moving->seconds += seconds;
    const float share = w.moving->seconds / TRANSITION_SECONDS;
    w.state = w.moving->last = between(w.moving->from, w.moving->to, share);
    if (share >= 1) w.moving.reset();
}

}  // namespace momentscope::ui
