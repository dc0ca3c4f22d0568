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

}  // namespace momentscope::ui
