// pinned_plots.hpp -- draws small plots of the pinned pixels.
#pragma once
#include "ui/model/measurement.hpp"
#include "ui/widgets/ui.hpp"

namespace momentscope::ui {

/// Draws the plots in a row of this size. A click on a plot goes to its pixel; its cross removes it.
void draw_pinned_plots(const Ui& ui, const Measurement& measurement, ExplorerState& state, ImVec2 size);

}  // namespace momentscope::ui
