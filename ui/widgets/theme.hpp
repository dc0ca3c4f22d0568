// theme.hpp -- fonts, colours and spacing, dark and light.
#pragma once
#include <imgui.h>

#include <array>

#include "ui/model/state.hpp"

namespace momentscope::ui {

/// Colours of the plot and the scene view. The curves have the colours of Okabe and Ito, which colour-blind
/// people can tell apart; the light theme uses the darker ones.
struct Palette {
    ImU32 text, warning;
    ImU32 plot_background, grid, axis;
    ImU32 truth, reconstruction, bounds, band, sharp, unbiased_exact, stems, errors, wrapping_zone,
        wrapping_zone_fill, exit;
    std::array<ImU32, 4> compared;  // used in turn, each with its own dash pattern
    ImU32 mark, mark_edge, pin;
};
const Palette& palette(ThemeKind kind);

/// Loads DejaVu Sans with Greek and mathematical signs for labels, and its bold style for headings. Throws
/// Error if the font is not installed. Call it once per ImGui context.
void load_fonts(float scale);
ImFont* bold_font();

/// Sets ImGui's colours and sizes. It is cheap; call it if kind or scale changed.
void apply_style(ThemeKind kind, float scale);

}  // namespace momentscope::ui
