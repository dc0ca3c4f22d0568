#include "ui/state.hpp"

#include <algorithm>

namespace momentscope::ui {

void choose_scene(ExplorerState& state, const std::string& id_or_path) {
    state.scene = id_or_path;
    state.ray.reset();
    state.camera.reset();
    state.picked.reset();
    state.pins.clear();
    state.marked.reset();
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
