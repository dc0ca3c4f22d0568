#include "ui/state.hpp"

namespace momentscope::ui {

void choose_scene(ExplorerState& state, const std::string& id_or_path) {
    state.scene = id_or_path;
    state.ray.reset();
    state.camera.reset();
    state.picked.reset();
    state.pins.clear();
    state.marked.reset();
    fit(state.plot);
}

void fit(PlotState& plot) {
    plot.depth.reset();
    plot.value.reset();
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
