#include "ui/state.hpp"

namespace momentscope::ui {

void choose_scene(ExplorerState& state, const std::string& id_or_path) {
    state.scene = id_or_path;
    state.ray.reset();
    state.camera.reset();
    state.picked.reset();
    state.pins.clear();
    state.marked.reset();
    state.plot.depth.reset();
    state.plot.value.reset();
}

}  // namespace momentscope::ui
