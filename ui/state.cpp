#include "ui/state.hpp"

#include "core/shadow/shadow_settings.hpp"

#include <algorithm>
#include <utility>

namespace momentscope::ui {

bool seen_from_light(const ExplorerState& state) {
    return state.viewpoint != Viewpoint::eye && !state.ray && has_shadows(state.parameters);
}

void set_viewpoint(ExplorerState& state, Viewpoint viewpoint) {
    const bool before = state.viewpoint != Viewpoint::eye, after = viewpoint != Viewpoint::eye;
    if (after && !before) {
        state.parameters.turn(ParameterId::shadows, true);
        state.receiver = std::exchange(state.marked, std::nullopt);
    } else if (before && !after) {
        state.marked = state.receiver;
    } else if (viewpoint != state.viewpoint) {
        state.marked.reset();  // it belongs to another ray
    }
    state.viewpoint = viewpoint;
    state.plot.query.reset();
    fit(state.plot);
}

Configuration plotted_configuration(const ExplorerState& state) {
    if (!seen_from_light(state)) return {state.technique, state.parameters};
    return state.viewpoint == Viewpoint::opaque_casters ? opaque_configuration(state.parameters)
                                                        : light_configuration(state.parameters);
}

void choose_scene(ExplorerState& state, const std::string& id_or_path) {
    state.scene = id_or_path;
    state.ray.reset();
    state.camera.reset();
    state.picked.reset();
    state.pins.clear();
    state.marked.reset();
    state.receiver.reset();
    state.compare.region.reset();
    fit(state.plot);
}

void fit(PlotState& plot) {
    plot.depth.reset();
    plot.value.reset();
}

void toggle(CompareState& compare, CompareMode mode) {
    compare.mode = compare.mode == mode ? CompareMode::off : mode;
}

LensZoom zoomed(LensZoom zoom, int steps) {
    const int last = static_cast<int>(LENS_ZOOM_COUNT) - 1;
    return static_cast<LensZoom>(std::clamp(static_cast<int>(zoom) + steps, 0, last));
}

void set_quantity(PlotState& plot, Quantity quantity) {
    plot.quantity = quantity;
    plot.value.reset();
}

void set_depth_axis(PlotState& plot, DepthAxis axis) {
    plot.axis = axis;
    plot.depth.reset();
}

}  // namespace momentscope::ui
