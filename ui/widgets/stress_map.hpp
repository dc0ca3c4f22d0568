// stress_map.hpp -- draws failure rates as a heat map of techniques and conditions, for the window's panel
// and for pictures.
#pragma once
#include <optional>

#include "core/stress/stress.hpp"
#include "ui/widgets/ui.hpp"

namespace momentscope::ui {

/// The size of the map of these cells in pixels at the current font.
ImVec2 stress_map_size(const std::vector<StressCell>& cells);

/// Draws the map at the cursor and returns the cell that was clicked. The cells are ordered technique by
/// technique and determine rows and columns. A tooltip shows the numbers of a cell.
std::optional<std::size_t> draw_stress_map(const Ui& ui, const std::vector<StressCell>& cells);

}  // namespace momentscope::ui
