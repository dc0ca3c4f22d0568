// plot_layers.hpp -- draws the series over the axes, with one function per series.
#pragma once
#include <optional>

#include "ui/plot/plot_axes.hpp"
#include "ui/widgets/lines.hpp"

namespace momentscope::ui {

/// The input of all layers.
struct PlotInput {
    const Measurement& measurement;
    const ExplorerState& state;
    std::optional<Series> highlighted;  // the legend entry under the mouse; other series are dimmed
};

/// Draws all series that the state shows, in an order in which none hides another.
void draw_layers(ImDrawList& list, const PlotAxes& axes, const Palette& colors, const PlotInput& input);

/// Draws only truth, band and reconstruction, for the small plots of pinned pixels.
void draw_small_layers(ImDrawList& list, const PlotAxes& axes, const Palette& colors, const ViewRay& ray,
                       const Curve& curve);

/// The dashes of the unbiased exact curve and of the sharp bounds.
inline const ImVec2 UNBIASED_EXACT_DASH = {7, 4};
inline const ImVec2 SHARP_DASH = {2, 3};

/// The dash lengths of the i-th compared technique: pixels on and off.
ImVec2 dash_of(std::size_t i);

}  // namespace momentscope::ui
