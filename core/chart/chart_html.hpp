// chart_html.hpp -- a chart as one page that needs no other file.
#pragma once
#include <string>

#include "core/chart/chart.hpp"

namespace momentscope {

/// Drawings of all scenes by all metrics, `metric` shown first. A pointer over a mark tells its name; a click
/// shows its numbers and the command that opens it in the window.
std::string chart_to_html(const Chart& chart, Metric metric);

/// All scenes' drawings above each other, by one metric.
std::string chart_to_svg(const Chart& chart, Metric metric);

/// The command that shows a row in the window: "momentscope explore --scene teapots --technique at --nodes
/// 8".
std::string explore_command(const Chart& chart, const ChartRow& row);

}  // namespace momentscope
