// chart_csv.hpp -- rows of a chart as lines of a CSV file.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/chart/chart_row.hpp"
#include "core/table/run_table.hpp"

namespace momentscope {

constexpr int CHART_SCHEMA = 2;  // counts changes of the columns and of what they mean

/// The names of the columns.
std::string chart_columns();

/// Six digits of every number; empty where there is none.
std::string chart_line(const ChartRow& row);

/// Throws Error that calls the file `name` when the line is no such row.
ChartRow parse_chart_line(std::string_view line, std::string_view name);

/// All rows of a table of the command chart. Throws Error when it is of another command or schema.
std::vector<ChartRow> chart_rows(const RunTable& table, std::string_view name);

}  // namespace momentscope
