#include "ui/window/update.hpp"

#include <fmt/format.h>

#include <chrono>
#include <utility>

#include "core/scene/scenes.hpp"
#include "core/shadow/shadow_settings.hpp"
#include "core/support/error.hpp"
#include "ui/model/selection.hpp"

namespace momentscope::ui {

namespace {

void apply_opacity(Workspace& w) {
    if (!w.scene.apply_opacity(w.state)) return;
    w.picture.set_objects(w.scene.scene());
    w.comparison.forget_reference();
}

void show_scene(Workspace& w, Scene scene) {
    w.picture.set_scene(scene);
    w.comparison.forget_reference();
    w.scene.show(std::move(scene));
    w.scene_picture.scene_camera = w.scene.scene().camera;
    w.status.warning = w.scene.warning();
    if (!w.status.warning.empty()) w.status.say(w.status.warning);
    apply_opacity(w);
}

// If the scene cannot be loaded, shows the error and goes back to the state that is shown.
void take_read_scene(Workspace& w) {
    if (!w.scene.is_reading()) return;
    try {
        if (std::optional<Scene> scene = w.scene.take_read()) show_scene(w, *std::move(scene));
    } catch (const Error& error) {
        if (w.scene.shows_nothing()) throw;
        w.status.say(error.what());
        go_back_to_shown(w);
    }
}

void update_scene(Workspace& w) {
    if (std::optional<Scene> scene = w.scene.take_wanted(w.state))
        show_scene(w, *std::move(scene));
    else if (!w.scene.is_reading())
        apply_opacity(w);
}

PictureKind picture_kind(const Workspace& w, const View& view, Stage stage) {
    PictureKind kind = {.scene = w.state.scene, .technique = view.technique, .stage = stage};
    for (const Parameter& row : parameters())
        if (row.scale != Scale::linear && row.scale != Scale::logarithmic)
            kind.choices.push_back(view.parameters[row.id]);
    if (w.comparison.wants_reference(w.state)) {
        kind.reference = w.state.compare.reference;
        kind.reference_stage = w.comparison.reference().stale_stage(reference_view(w.state, view));
    }
    kind.failures = w.state.failures && (stage <= Stage::color || !w.shown.failures);
    kind.uncertainty = w.comparison.measures_uncertainty(w.state, stage);
    return kind;
}

// Called before anything is drawn, while the window still shows the last frame. True if the picture waits for
// the next frame.
bool announce(Workspace& w, const PictureKind& kind, glm::ivec2 size) {
    if (!w.options.before_long_picture) return false;
    const bool waited = std::exchange(w.picture_waits, false);
    const bool nothing = kind.stage == Stage::nothing && kind.reference_stage == Stage::nothing;
    if (waited || (nothing && !kind.failures && !kind.uncertainty)) return false;
    const auto expected = w.picture_times.expected(kind, size);
    const bool is_long = !expected || *expected > w.options.most_silent_milliseconds;
    return w.picture_waits = is_long && w.options.before_long_picture();
}

void update_ray(Workspace& w, const Update& update) {
    w.comparison.stop();
    if (w.picked.update_ray(update)) w.picture.forget();  // the picture is no longer shown
}

void update_full_picture(Workspace& w, const Update& update, const PictureChange& change) {
    Renderer& renderer = w.picture.renderer();
    const Scene& scene = w.scene.scene();
    w.picture.draw(change, update.report);
    w.comparison.update(update, change, renderer, scene);  // this may pick another pixel
    w.picked.update(update, change, renderer, scene);
    update_scene_picture(w.scene_picture, update, change, renderer, w.comparison, w.measurement().pixel);
}

// Picks the next failed pixel for the next frame.
void pick_next_failed(Workspace& w, glm::ivec2 size) {
    if (!std::exchange(w.failed_wanted, false)) return;
    const auto& failures = w.scene_picture.failures;
    if (!failures) return w.status.say("This technique has no moments, so no reconstruction can fail.");
    const auto next = next_place(failures->failed_pixels, w.measurement().pixel);
    if (!next) return w.status.say("No pixel has failed.");
    pick(w.state, fraction_of(*next, size));
    w.status.say(fmt::format("One of {} failed pixels: {}, {}.", failures->failed, next->x, next->y));
}

void update_draft(Workspace& w, const Update& update, const PictureChange& change) {
    update.report.draft = w.picture.draw_draft(change.now);
    w.picked.update_draft(update, change, w.picture.draft(), update.report.draft, w.scene.scene());
    show_draft(w.scene_picture, w.picture.draft());
}

void update_picture(Workspace& w, const Update& update, glm::ivec2 size, Pointer pointer) {
    const auto begun = std::chrono::steady_clock::now();
    ExplorerState& state = w.state;
    if (state.viewpoint != Viewpoint::eye && !has_shadows(state.parameters))
        set_viewpoint(state, Viewpoint::eye);  // shadows were turned off
    const bool builds_scene = state.scene != w.scene.scene().id && is_builtin_scene(state.scene);
    const auto view = [&] { return View{w.camera(), size, state.technique, state.parameters}; };
    if (builds_scene && announce(w, picture_kind(w, view(), Stage::opaque), size)) return;
    update_scene(w);
    if (w.scene.is_reading()) return;
    const PictureChange change = w.picture.change_to(view());
    if (w.picture.wants_draft(change, pointer)) return update_draft(w, update, change);
    const PictureKind kind = picture_kind(w, change.now, change.stage);
    if (!builds_scene && announce(w, kind, size)) return;
    update_full_picture(w, update, change);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begun;
    w.picture_times.took(kind, size, took.count());
}

void update_content(Workspace& w, glm::ivec2 size, Pointer pointer) {
    take_read_scene(w);
    if (w.scene.is_reading()) return;  // the old content stays until the scene is there
    const auto open = w.course.open_step(w.state);
    const Update update = {w.state, w.shown, w.status, w.report,
                           open && measures(open->content(), MeasureId::color_error)};
    w.comparison.want_error(open && measures(open->content(), MeasureId::picture_error));
    if (w.state.ray)
        update_ray(w, update);
    else
        update_picture(w, update, size, pointer);
    if (w.scene.is_reading() || w.picture_waits) return;
    w.shown = w.state;
    if (w.state.ray)
        w.failed_wanted = false;
    else
        pick_next_failed(w, size);
    auto bounds = w.sharp_bounds.update(w.state.plot, w.measurement(), w.picked.number(), w.status);
    if (bounds) w.picked.set_sharp_bounds(*std::move(bounds));
}

}  // namespace

void take_results(Workspace& w) {
    w.stress.poll();
    w.tuning.poll(w.state, w.status);
    w.comparison.poll();
    if (!w.scene.is_reading()) w.chart.work(w.state, w.status);
}

void update_window(Workspace& w, glm::ivec2 size, Pointer pointer) {
    w.report = {};
    try {
        update_content(w, size, pointer);
    } catch (const Error& error) {
        if (w.picked.empty()) throw;
        w.status.say(error.what());
        go_back_to_shown(w);
        w.picture.forget();
        w.comparison.forget_worst();
    }
    w.status.progress = w.scene.progress();
}

}  // namespace momentscope::ui
