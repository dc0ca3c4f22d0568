// presenting.hpp -- a lecture: steps of lessons one after another, with nothing else in the window.
#pragma once
#include "ui/workspace/workspace.hpp"

namespace momentscope::ui {

/// Goes to the next or the previous step of the course. Without an open lesson, opens the first one. While
/// presenting, each step comes twice: as it starts, and solved with its answer.
void next_step(Workspace& workspace);
void previous_step(Workspace& workspace);

/// Moves on between two states. Call it at the begin of each frame.
void move_on(Workspace& workspace, float seconds);

}  // namespace momentscope::ui
