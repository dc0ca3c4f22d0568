// measures.hpp -- the numbers that lessons ask for, from what the window shows.
#pragma once
#include <optional>
#include <string>

#include "ui/workspace/workspace.hpp"

namespace momentscope::ui {

/// nullopt if the window does not show what the number needs, or is still computing it.
std::optional<double> measured(MeasureId id, const Workspace& workspace);

/// The number with the digits of its row; "–" if there is none.
std::string measure_text(MeasureId id, const Workspace& workspace);

}  // namespace momentscope::ui
