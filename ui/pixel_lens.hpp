// pixel_lens.hpp -- pixels around the picked one, magnified, with their values where there is room.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "ui/state.hpp"
#include "ui/ui.hpp"

namespace momentscope::ui {

struct LensPixel {
    std::array<unsigned char, 3> color{};  // sRGB
    std::array<std::string, 3> values;     // written into it; empty: none
};

struct Lens {
    glm::ivec2 corner{0};  // of its upper left pixel in the picture
    glm::ivec2 extent{0};  // 0: no lens
    std::vector<LensPixel> pixels;
    std::string values;  // what the numbers are, as "sRGB"
};

/// How far the lens reaches from its middle, in pixels.
int lens_radius(LensZoom zoom);

/// Draws it into the lower left corner of the picture's area, or into the right one where it would hide the
/// picked pixel, which it frames. Returns the height that it took in the left corner.
float draw_lens(ImDrawList& list, const Rect& area, const Lens& lens, LensZoom zoom, glm::ivec2 pixel,
                const Palette& colors);

/// Text on a background of its own, with its upper left corner at `at`.
void draw_label(ImDrawList& list, ImVec2 at, const std::string& text, const Palette& colors);

}  // namespace momentscope::ui
