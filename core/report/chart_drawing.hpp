// chart_drawing.hpp -- draws the rows of one scene as a scatter plot of time and error.
#pragma once
#include <span>

#include "core/chart/chart.hpp"
#include "core/report/drawing.hpp"

namespace momentscope {

/// The size of a drawing in its own pixels. Letters are 11 to 17 pixels high.
struct ChartLayout {
    glm::vec2 size{1120, 720};
    bool title = true;   // false if the scene is named elsewhere
    bool legend = true;  // if there is room for it
};

/// Draws the rows of one scene. Both axes are logarithmic. Time is the total time. The difference to
/// `unsorted` could not be drawn, because noise may make it zero or negative, and then it has no logarithm; a
/// dashed line marks `unsorted` instead. Errors below a 250th of the greatest error are drawn in a strip at
/// the bottom. The Pareto front is a line. Names are written where there is room. `times` says how times were
/// measured; it may be empty.
Drawing chart_drawing(std::span<const ChartRow> rows, Metric metric, const std::string& times,
                      const ChartLayout& layout = {});

}  // namespace momentscope
