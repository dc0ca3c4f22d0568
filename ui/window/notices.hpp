// notices.hpp -- what the window says while the user waits.
#pragma once
#include "ui/workspace/workspace.hpp"

namespace momentscope::ui {

/// "drawing…" over the last frame, or, before the first picture, the names of the program and of the scene.
void draw_waiting(ImDrawList& list, const Workspace& workspace);

/// The scene that is being read, with a button that stops it; nothing if none is.
void draw_reading_notice(const Ui& ui, Workspace& workspace);

}  // namespace momentscope::ui
