// chart_drawing.hpp -- the rows of one scene as a scatter plot of time against error.
#pragma once
#include <span>

#include "core/chart/chart.hpp"
#include "core/chart/drawing.hpp"

namespace momentscope {

/// How large a drawing is in its own pixels, in which letters are 11 to 17 high.
struct ChartLayout {
    glm::vec2 size{1120, 720};
    bool title = true;   // else the scene is named elsewhere
    bool legend = true;  // where there is room for it
};

/// Both axes are logarithmic. Time is the total: the difference to `unsorted` may be zero or less where noise
/// is as great, which a logarithm cannot show; a dashed line stands where `unsorted` is. Errors below a
/// 250th of the greatest stand in a strip at the bottom. The Pareto front is a line. Names are written
/// where there is room. `times` says how times were taken; may be
/// empty.
Drawing chart_drawing(std::span<const ChartRow> rows, Metric metric, const std::string& times,
                      const ChartLayout& layout = {});

}  // namespace momentscope
