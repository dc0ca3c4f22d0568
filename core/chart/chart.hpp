// chart.hpp -- a finished chart as tables and drawings see it.
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

/// Throws Error when the table is no chart; `name` is what it calls it.
Chart chart_of(const RunTable& table, std::string_view name);

/// The rows of each scene, in order.
std::vector<std::span<const ChartRow>> scenes_of(const Chart& chart);

double error_of(const ChartNumbers& numbers, Metric metric);

/// Indices of the rows that no other one of the scene beats in total time and error, by growing time.
std::vector<std::size_t> front_of(std::span<const ChartRow> rows, Metric metric);

/// How the numbers came about, in a few sentences.
std::string chart_method(const Chart& chart);

/// A short name: "at nodes=8", "mt quarter theta16".
std::string short_name(const std::string& configuration);

/// One table per scene as Markdown, with what is measured and how.
std::string chart_to_markdown(const Chart& chart, Metric metric);

}  // namespace momentscope
