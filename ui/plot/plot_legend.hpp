// plot_legend.hpp -- the legend of the plot, whose entries can be clicked.
#pragma once
#include <optional>

#include "ui/model/measurement.hpp"
#include "ui/widgets/ui.hpp"

namespace momentscope::ui {

/// Draws an entry per series and per compared technique, in lines that end at `right`. A click shows or hides
/// a series, or removes a compared technique. Returns the series under the mouse if it is shown.
std::optional<Series> draw_legend(const Ui& ui, const Measurement& measurement, ExplorerState& state,
                                  float right);

/// The height that draw_legend takes in lines of this width.
float legend_height(const Measurement& measurement, float width);

}  // namespace momentscope::ui
