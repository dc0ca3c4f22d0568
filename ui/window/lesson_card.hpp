// lesson_card.hpp -- the row of lessons, and the card of the open one.
#pragma once
#include "ui/workspace/workspace.hpp"

namespace momentscope::ui {

/// The row of lessons above the window.
void draw_lesson_row(const Ui& ui, Workspace& workspace);

/// The open lesson, if there is one, at most this high in pixels. Its text scrolls.
void draw_lesson_card(const Ui& ui, Workspace& workspace, float most);

/// Rings around the controls that the open step points at. Call it after everything else was drawn.
void draw_highlights(const Ui& ui, const Workspace& workspace);

}  // namespace momentscope::ui
