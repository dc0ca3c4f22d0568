// drawing_painter.hpp -- paints drawings with ImGui.
#pragma once
#include <imgui.h>

#include "core/report/drawing.hpp"

namespace momentscope::ui {

/// Paints a drawing with its upper left corner at `origin`, enlarged by `scale`.
void paint_drawing(ImDrawList& list, const Drawing& drawing, ImVec2 origin, float scale);

}  // namespace momentscope::ui
