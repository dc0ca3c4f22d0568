// theme.hpp -- fonts and colours.
#pragma once
#include <imgui.h>

namespace momentscope::ui {

/// Colours of the curves: Okabe and Ito's palette, which colour-blind people tell apart.
namespace color {
constexpr ImU32 TRUTH = IM_COL32(240, 240, 240, 255);
constexpr ImU32 RECONSTRUCTION = IM_COL32(230, 159, 0, 255);
constexpr ImU32 BOUNDS = IM_COL32(86, 180, 233, 255);
constexpr ImU32 BAND = IM_COL32(86, 180, 233, 45);
constexpr ImU32 WRAPPING_ZONE = IM_COL32(204, 121, 167, 60);
constexpr ImU32 GRID = IM_COL32(255, 255, 255, 28);
constexpr ImU32 TEXT = IM_COL32(205, 210, 216, 255);
constexpr ImU32 PLOT_BACKGROUND = IM_COL32(22, 24, 28, 255);
constexpr ImU32 LEGEND_BACKGROUND = IM_COL32(22, 24, 28, 200);
constexpr ImU32 MARK = IM_COL32(255, 255, 255, 255);
constexpr ImU32 MARK_EDGE = IM_COL32(0, 0, 0, 255);
}  // namespace color

/// Loads DejaVu Sans with Greek and the mathematical signs that labels use, and sets the style. Throws Error
/// when the font is not installed. Call once per ImGui context.
void apply_theme(float scale);

}  // namespace momentscope::ui
