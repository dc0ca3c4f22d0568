// chart_output.hpp -- writes the files of a chart; the extension chooses the kind.
#pragma once
#include <filesystem>

#include "core/compare/difference.hpp"
#include "core/table/run_table.hpp"

namespace momentscope {

/// Throws Error unless the path ends in .csv, .md, .svg, .html or .png and can be written.
void require_chart_output(const std::filesystem::path& path);

/// Writes the table as the kind of file that the extension names. `metric` is the error of drawings and
/// fronts. Throws Error if the table does not come from chart, except when it is copied as .csv.
void write_chart(const RunTable& table, Metric metric, const std::filesystem::path& path);

}  // namespace momentscope
