// chart_output.hpp -- files of a chart, by their extension.
#pragma once
#include <filesystem>

#include "core/compare/difference.hpp"
#include "core/table/run_table.hpp"

namespace momentscope {

/// Throws Error unless the path ends in .csv, .md, .svg, .html or .png and can be written.
void require_chart_output(const std::filesystem::path& path);

/// Writes the table as what the extension says; `metric` is the error of drawings and fronts. Throws Error
/// when the table is none of chart, unless it is copied as .csv.
void write_chart(const RunTable& table, Metric metric, const std::filesystem::path& path);

}  // namespace momentscope
