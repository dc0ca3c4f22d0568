// stress_report.hpp -- the cells of a stress run as CSV, as a page, and as text for the terminal.
#pragma once
#include <glm/glm.hpp>
#include <string>

#include "core/stress/stress.hpp"

namespace momentscope {

/// One row per cell with all its numbers and its worst ray as JSON.
std::string stress_to_csv(const std::vector<StressCell>& cells);

/// The same behind what the run was, so that shards of it can be merged.
RunTable stress_table(const std::vector<StressCell>& cells, const StressOptions& options);

/// One self-contained page: the heat map, and every cell's numbers and worst ray under its title.
std::string stress_to_html(const std::vector<StressCell>& cells, const StressOptions& options);

/// A summary: one line per technique with its failures, and its worst conditions.
std::string stress_to_text(const std::vector<StressCell>& cells);

/// What a map of cells shows, and under which solver, bias preset and how many rays.
std::string stress_title(const StressOptions& options);

/// sRGB of a failure rate: from dark blue for 0 through yellow to red above one in ten, told apart by the
/// colour-blind by their lightness too.
glm::vec3 failure_color(double rate);

/// "0", "3.1e-4", "12 %": as short as a cell of the map.
std::string rate_text(double rate);

/// What happened in a cell, in one or two sentences.
std::string cell_sentence(const StressCell& cell);

}  // namespace momentscope
