// stress_report.hpp -- writes the cells of a stress run as CSV, as a page, and as text for the terminal.
#pragma once
#include <glm/glm.hpp>
#include <string>

#include "core/stress/stress.hpp"

namespace momentscope {

/// CSV with one row per cell: all its numbers, and its worst ray as JSON.
std::string stress_to_csv(const std::vector<StressCell>& cells);

/// The same as a table with the settings of the run, so that shards can be merged.
RunTable stress_table(const std::vector<StressCell>& cells, const StressOptions& options);

/// A self-contained page: the heat map, where the tooltip of each cell has its numbers, and a list of the
/// cells with failures and their worst rays.
std::string stress_to_html(const std::vector<StressCell>& cells, const StressOptions& options);

/// A summary: one line per technique with its failures, and its worst conditions.
std::string stress_to_text(const std::vector<StressCell>& cells);

/// A title that says what a map of cells shows, with solver, bias preset and number of rays.
std::string stress_title(const StressOptions& options);

/// The sRGB colour of a failure rate: from dark blue for 0 through yellow to red above one in ten. The
/// colours differ in lightness, too, so colour-blind people can tell them apart.
glm::vec3 failure_color(double rate);

/// The text of a rate, short enough for a cell of the map: "0", "3.1e-4", "12 %".
std::string rate_text(double rate);

/// A description of the results in a cell, in one or two sentences.
std::string cell_sentence(const StressCell& cell);

}  // namespace momentscope
