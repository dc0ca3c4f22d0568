// drawing_painter.hpp -- drawings on the screen.
#pragma once
#include <imgui.h>

#include "core/chart/drawing.hpp"

namespace momentscope::ui {

/// Paints a drawing with its upper left at `origin`, so many times as large.
void paint_drawing(ImDrawList& list, const Drawing& drawing, ImVec2 origin, float scale);

}  // namespace momentscope::ui
