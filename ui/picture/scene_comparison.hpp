// scene_comparison.hpp -- draws the parts of a comparison over the picture: divider, labels, legend, region.
#pragma once
#include <optional>
#include <string>

#include "core/compare/difference.hpp"
#include "ui/model/state.hpp"
#include "ui/widgets/ui.hpp"

namespace momentscope::ui {

/// The meaning of the false colours.
struct ColorLegend {
    const char* name = "";  // of what they show
    float end = 1;          // of the colours
    float least = 0, most = 0;
    bool computing = false;  // the metric is being computed; the colours are those of the last pair
};

/// The area where the divider can be grabbed.
Rect divider_area(const Rect& area, const CompareState& compare);

/// Draws the line between the sides, and a technique label on each side if there is space.
void draw_wipe(ImDrawList& list, const Rect& area, const ExplorerState& state, const Palette& colors);

/// Draws the legend in the upper right corner.
void draw_color_legend(ImDrawList& list, const Rect& area, const ColorLegend& legend, const Palette& colors);

/// Draws the frame of the region.
void draw_region(ImDrawList& list, const Rect& area, const PictureRegion& region, const Palette& colors);

}  // namespace momentscope::ui
