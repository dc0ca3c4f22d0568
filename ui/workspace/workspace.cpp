#include "ui/workspace/workspace.hpp"

#include <utility>

#include "ui/model/selection.hpp"
#include "ui/workspace/keeping.hpp"

namespace momentscope::ui {

namespace {

// Where rounding errors are lost, moments need more bias.
ExplorerState started_on(ExplorerState state, const Capabilities& gl) {
    if (gl.language.rounding == Rounding::lost) state.parameters.set(BiasPreset::robust);
    return state;
}

}  // namespace

Workspace::Workspace(Renderer& renderer, ExplorerState start, WindowOptions window_options)
    : options(std::move(window_options)),
      gl(gl_info(renderer.gl())),
      state(started_on(std::move(start), renderer.gl())),
      shown(state),
      history(state),
      picture(renderer, options.most_milliseconds),
      settings(options.settings) {
    restore_kept(*this);
}

bool has_background_work(const Workspace& w) {
    return w.stress.busy() || w.tuning.busy() || w.sharp_bounds.busy() || w.comparison.numbers().busy();
}

bool wants_frame(const Workspace& w) {
    return !(w.state == w.shown) || w.picture_waits || w.scene.is_reading() || has_background_work(w) ||
           w.comparison.wants_worst() || w.failed_wanted || w.picture.shows_draft() || w.chart.busy() ||
           w.moving || w.lesson.has_changed();
}

// The last change may not be recorded as a step yet.
void undo(Workspace& w) {
    w.history.record(w.state);
    if (w.history.can_undo()) w.state = w.history.undo();
}

void redo(Workspace& w) {
    w.history.record(w.state);
    if (w.history.can_redo()) w.state = w.history.redo();
}

void go_back_to_shown(Workspace& w) {
    w.history.reject_present(w.shown);
    w.state = w.shown;
}

void type_parameter(Workspace& w, ParameterId id) {
    w.state.panel = Panel::controls;
    w.to_type = id;
}

void want_next_failed(Workspace& w) {
    w.state.failures = true;
    w.failed_wanted = true;
}

void measure_chart(Workspace& w) {
    w.state.panel = Panel::chart;
    w.chart.start(w.scene.scene(), w.state, w.status);
}

void close_topmost(Workspace& w) {
    if (w.palette.open)
        w.palette.open = false;
    else if (w.escape_is_taken)
        return;
    else if (w.help)
        w.help = false;
    else if (!w.status.message.empty())
        w.status.message.clear();
    else if (w.state.compare.region)
        forget_region(w.state.compare);
    else if (w.present)
        w.present = false;
    else
        close_card(w.state);
}

}  // namespace momentscope::ui
