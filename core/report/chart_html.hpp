// chart_html.hpp -- writes a chart as one page that needs no other file.
#pragma once
#include <string>

#include "core/chart/chart.hpp"

namespace momentscope {

/// Drawings of all scenes with all metrics; `metric` is shown first. A mark shows its name under the pointer.
/// A click shows its numbers, and the command that opens it in the window.
std::string chart_to_html(const Chart& chart, Metric metric);

/// The drawings of all scenes, one above another, with one metric.
std::string chart_to_svg(const Chart& chart, Metric metric);

/// The command that shows a row in the window: "momentscope explore --scene teapots --technique at --nodes
/// 8".
std::string explore_command(const Chart& chart, const ChartRow& row);

}  // namespace momentscope
