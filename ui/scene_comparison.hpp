// scene_comparison.hpp -- what a comparison draws over the picture: divider, labels, legend, region.
#pragma once
#include <optional>
#include <string>

#include "core/compare/difference.hpp"
#include "ui/state.hpp"
#include "ui/ui.hpp"

namespace momentscope::ui {

/// What false colours mean.
struct ColorLegend {
    Metric metric = Metric::rmse;
    float end = 1;  // of the colours
    float least = 0, most = 0;
    bool computing = false;  // of these pictures: the colours are those of the last ones
};

/// Where the divider can be grabbed.
Rect divider_area(const Rect& area, const CompareState& compare);

/// The line between the sides, and a label of the technique on each side where there is room.
void draw_wipe(ImDrawList& list, const Rect& area, const ExplorerState& state, const Palette& colors);

/// In the upper right corner.
void draw_color_legend(ImDrawList& list, const Rect& area, const ColorLegend& legend, const Palette& colors);

/// The frame of the region that was dragged.
void draw_region(ImDrawList& list, const Rect& area, const PictureRegion& region, const Palette& colors);

}  // namespace momentscope::ui
