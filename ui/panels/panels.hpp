// panels.hpp -- the tabs below the plot: draw_<id>_panel for every row of ui/model/panels.def, each in a file
// of its own.
#pragma once
#include "ui/workspace/workspace.hpp"

namespace momentscope::ui {

#define PANEL(id, name, help) void draw_##id##_panel(const Ui& ui, Workspace& workspace);
#include "ui/model/panels.def"
#undef PANEL

/// Draws the open tab.
void draw_open_panel(const Ui& ui, Workspace& workspace);

}  // namespace momentscope::ui
