// compare_panel.hpp -- the tab that compares the picture with a reference.
#pragma once
#include "core/render/transparency.hpp"
#include "ui/comparison.hpp"
#include "ui/ui.hpp"

namespace momentscope::ui {

/// Draws reference, mode and the numbers of each metric. Returns true if the next worst pixel was requested.
bool draw_compare_panel(const Ui& ui, OrderedAccess access, Comparison& comparison, ExplorerState& state);

}  // namespace momentscope::ui
