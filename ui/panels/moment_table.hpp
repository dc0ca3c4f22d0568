// moment_table.hpp -- the moments of each fragment as numbers and bars, and their sums: step 0 of every
// reconstruction.
#pragma once
#include "ui/workspace/workspace.hpp"

namespace momentscope::ui {

/// Draws the table in a width in pixels. A click on a row marks its fragment.
void draw_moment_table(const Ui& ui, Workspace& workspace, float width);

/// What the window shows in place of the scene for a ray without one: its colours and its moments.
void draw_own_ray(const Ui& ui, Workspace& workspace, const Rect& area);

}  // namespace momentscope::ui
