#include "ui/picture/picked_ray.hpp"

#include "core/render/view_from_light.hpp"
#include "ui/model/selection.hpp"

namespace momentscope::ui {

void PickedRay::update(const Update& update, const PictureChange& change, Renderer& renderer,
                       const Scene& scene) {
    capture(update, change, renderer, scene);
    capture_pins(update, change, renderer, scene);
    measure(update, update.report.capture);
}

// The T of the second pass is captured only if it is shown.
void PickedRay::capture(const Update& update, const PictureChange& change, Renderer& renderer,
                        const Scene& scene) {
    const ExplorerState& state = update.state;
    const glm::ivec2 pixel = pixel_of(state.picked, scene, change.now.size);
    const bool light = seen_from_light(state);
    const bool moved =
        change.changes_fragments() || pixel != measurement_.pixel || of_draft_ ||
        light != measurement_.light.has_value() ||
        (light && (state.receiver != update.shown.receiver || state.viewpoint != update.shown.viewpoint));
    transmittance_stale_ |= change.stage <= Stage::color;
    if (!moved && (light || !(transmittance_stale_ && state.panel == Panel::fragments))) {
        if (transmittance_stale_) measurement_.capture.transmittance.clear();
        return;
    }
    measurement_.capture = renderer.capture_pixel(pixel);
    measurement_.pixel = pixel;
    measurement_.picture_size = change.now.size;
    measurement_.light.reset();
    if (light) see_from_light(update, renderer);
    transmittance_stale_ = false;
    of_draft_ = false;
    update.report.capture = true;
}

// Replaces the ray of the capture by the light's ray.
void PickedRay::see_from_light(const Update& update, Renderer& renderer) {
    ExplorerState& state = update.state;
    measurement_.light = view_from_light(renderer, measurement_.pixel, measurement_.capture, state.receiver);
    if (!measurement_.light) {
        update.status.say(
            "This pixel shows nothing that could receive light, so the plot shows the eye's ray; pick another one.");
        set_viewpoint(state, Viewpoint::eye);
        return;
    }
    measurement_.capture.ray = ray_of(*measurement_.light, state.viewpoint);
    measurement_.capture.transmittance.clear();
}

void PickedRay::capture_pins(const Update& update, const PictureChange& change, Renderer& renderer,
                             const Scene& scene) {
    const ExplorerState& state = update.state;
    if (!change.changes_fragments() && update.shown.pins == state.pins &&
        measurement_.pins.size() == state.pins.size())
        return;
    measurement_.pins.clear();
    for (const glm::vec2& place : state.pins) {
        const glm::ivec2 pixel = pixel_of(place, scene, measurement_.picture_size);
        measurement_.pins.push_back({pixel, renderer.capture_pixel(pixel).ray, {}});
        update.report.capture = true;
    }
    update.report.capture |= update.shown.pins != state.pins;
}

void PickedRay::update_draft(const Update& update, const PictureChange& change, DraftPicture& draft,
                             bool drawn, const Scene& scene) {
    if (drawn && change.changes_fragments()) {
        const ExplorerState& state = update.state;
        const glm::vec2 place = fraction_of(pixel_of(state.picked, scene, change.now.size), change.now.size);
        measurement_.capture = draft.capture(place);
        measurement_.light.reset();
        if (seen_from_light(state)) {
            measurement_.light = draft.light(place, measurement_.capture, state.receiver);
            measurement_.capture.ray =
                measurement_.light ? ray_of(*measurement_.light, state.viewpoint) : ViewRay();
        }
        update.report.capture = of_draft_ = true;
    }
    if (drawn) {
        measurement_.capture.transmittance.clear();
        transmittance_stale_ = true;
    }
    measure(update, update.report.capture);
}

bool PickedRay::update_ray(const Update& update) {
    const bool changed = !(update.shown.ray == update.state.ray) || empty();
    if (changed) {
        measurement_.capture = {.ray = *update.state.ray, .transmittance = {}, .stored = {}};
        measurement_.light.reset();
        measurement_.pins.clear();
    }
    measure(update, changed);
    return changed;
}

void PickedRay::require_transmittances(Renderer& renderer) {
    PixelCapture& capture = measurement_.capture;
    if (!measurement_.light && capture.transmittance.empty() && !capture.ray.fragments.empty())
        capture = renderer.capture_pixel(measurement_.pixel);
}

void PickedRay::measure(const Update& update, bool captured) {
    const ExplorerState& state = update.state;
    FrameReport& report = update.report;
    if (captured) ++number_;
    report.plot = captured || empty() || !same_curves(update.shown, state);
    if (report.plot) measure_curves(measurement_, state);
    breakdown_stale_ |= report.plot || update.shown.parameters != state.parameters;
    const bool shown = state.panel == Panel::fragments || update.breakdown;
    if (breakdown_stale_ && shown && !measurement_.light) {
        measure_breakdown(measurement_, state);
        breakdown_stale_ = false;
    }
    report.query = report.plot || query_depth(measurement_, state) != measurement_.canonical.query;
    if (report.query) measure_query(measurement_, state);
}

}  // namespace momentscope::ui
