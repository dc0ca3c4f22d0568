// plot_tools.hpp -- the buttons above the plot: which ray, which quantity, which depth; and the query depth.
#pragma once
#include "ui/model/measurement.hpp"
#include "ui/widgets/ui.hpp"

namespace momentscope::ui {

/// Draws them in lines that end at `right`. They change the state.
void draw_plot_tools(const Ui& ui, const Measurement& measurement, ExplorerState& state, float right);

}  // namespace momentscope::ui
