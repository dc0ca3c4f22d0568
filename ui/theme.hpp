// theme.hpp -- fonts, colours and spacing, dark and light.
#pragma once
#include <imgui.h>

#include <array>

#include "ui/state.hpp"

namespace momentscope::ui {

/// Colours of what the plot and the scene view draw. Those of curves are Okabe and Ito's, which colour-blind
/// people tell apart; the light theme takes the darker ones.
struct Palette {
    ImU32 text, warning;
    ImU32 plot_background, grid, axis;
    ImU32 truth, reconstruction, bounds, band, sharp, unbiased_exact, stems, errors, wrapping_zone,
        wrapping_zone_fill, exit;
    std::array<ImU32, 4> compared;  // in turn, with a dash pattern each
    ImU32 mark, mark_edge, pin;
};
const Palette& palette(ThemeKind kind);

/// Loads DejaVu Sans with Greek and the mathematical signs that labels use, and its bold for headings. Throws
/// Error when the font is not installed. Call once per ImGui context.
void load_fonts(float scale);
ImFont* bold_font();

/// Sets ImGui's colours and sizes. Cheap; call it when kind or scale changed.
void apply_style(ThemeKind kind, float scale);

}  // namespace momentscope::ui
