// stress_map.hpp -- techniques times conditions as a heat map of failure rates: in the window's panel and as
// a picture.
#pragma once
#include <optional>

#include "core/stress/stress.hpp"
#include "ui/ui.hpp"

namespace momentscope::ui {

/// How large the map of so many cells wants to be, in pixels at the current font.
ImVec2 stress_map_size(const std::vector<StressCell>& cells);

/// Draws the map at the cursor and returns the cell that was clicked. Rows and columns follow from the cells,
/// which are ordered technique by technique. Hovering tells a cell's numbers.
std::optional<std::size_t> draw_stress_map(const Ui& ui, const std::vector<StressCell>& cells);

}  // namespace momentscope::ui
