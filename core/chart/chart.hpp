// chart.hpp -- a finished chart, as tables and drawings use it.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/chart/chart_row.hpp"
#include "core/compare/difference.hpp"
#include "core/table/run_table.hpp"

namespace momentscope {

struct Chart {
    RunSettings settings;
    std::vector<ChartRow> rows;  // scene by scene
};

/// The chart in a table. Throws Error if the table is not a chart; `name` is what the sentence calls it.
Chart chart_of(const RunTable& table, std::string_view name);

/// The rows of each scene, in order.
std::vector<std::span<const ChartRow>> scenes_of(const Chart& chart);

double error_of(const ChartNumbers& numbers, Metric metric);

/// Indices of the rows of the Pareto front: no other row of the scene is better in total time and error. In
/// order of time.
std::vector<std::size_t> front_of(std::span<const ChartRow> rows, Metric metric);

/// A few sentences on how the numbers were measured.
std::string chart_method(const Chart& chart);

/// A short name of a configuration: "at nodes=8", "mt quarter theta16".
std::string short_name(const std::string& configuration);

/// The chart as Markdown: one table per scene, with what is measured and how.
std::string chart_to_markdown(const Chart& chart, Metric metric);

}  // namespace momentscope
