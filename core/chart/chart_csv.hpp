// chart_csv.hpp -- writes and reads rows of a chart as lines of a CSV file.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/chart/chart_row.hpp"
#include "core/table/run_table.hpp"

namespace momentscope {

constexpr int CHART_SCHEMA = 2;  // increases when columns or their meaning change

/// The names of the columns.
std::string chart_columns();

/// A row as a line, with six digits of every number. Unknown numbers are empty.
std::string chart_line(const ChartRow& row);

/// The row of a line. Throws Error, which calls the file `name`, if the line is not valid.
ChartRow parse_chart_line(std::string_view line, std::string_view name);

/// All rows of a table that the command chart wrote. Throws Error if the table belongs to another command or
/// schema.
std::vector<ChartRow> chart_rows(const RunTable& table, std::string_view name);

}  // namespace momentscope
