// update.hpp -- computes what the window shows from the state: which stages run again, and in which order.
#pragma once
#include "ui/workspace/workspace.hpp"

namespace momentscope::ui {

/// Takes over what background work has finished. Call it once per frame.
void take_results(Workspace& workspace);

/// Recomputes what the state's changes made stale, for a picture of this size. A failure is shown as a
/// message, and the last good state comes back. Throws Error only if there was no good state yet.
void update_window(Workspace& workspace, glm::ivec2 size, Pointer pointer);

}  // namespace momentscope::ui
