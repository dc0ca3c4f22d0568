// lines.hpp -- draws lines through points.
#pragma once
#include <imgui.h>

#include <vector>

namespace momentscope::ui {

/// Draws a line through the points.
void draw_line(ImDrawList& list, const std::vector<ImVec2>& points, ImU32 tint, float thickness);

/// Draws a line through the points that is dashed along its length.
void draw_dashed(ImDrawList& list, const std::vector<ImVec2>& points, ImU32 tint, float thickness,
                 ImVec2 dash);

}  // namespace momentscope::ui
