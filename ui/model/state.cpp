#include "ui/model/state.hpp"

#include <algorithm>

#include "core/shadow/shadow_settings.hpp"
#include "ui/model/selection.hpp"

namespace momentscope::ui {

Configuration plotted_configuration(const ExplorerState& state) {
    if (!seen_from_light(state)) return {state.technique, state.parameters};
    return state.viewpoint == Viewpoint::opaque_casters ? opaque_configuration(state.parameters)
                                                        : light_configuration(state.parameters);
}

void toggle(CompareState& compare, CompareMode mode) {
    compare.mode = compare.mode == mode ? CompareMode::off : mode;
}

LensZoom zoomed(LensZoom zoom, int steps) {
    const int last = static_cast<int>(LENS_ZOOM_COUNT) - 1;
    return static_cast<LensZoom>(std::clamp(static_cast<int>(zoom) + steps, 0, last));
}

}  // namespace momentscope::ui
