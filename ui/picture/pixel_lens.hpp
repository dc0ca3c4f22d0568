// pixel_lens.hpp -- magnifies the pixels around the picked one and shows their values where there is space.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "ui/model/state.hpp"
#include "ui/widgets/ui.hpp"

namespace momentscope::ui {

struct LensPixel {
    std::array<unsigned char, 3> color{};  // sRGB
    std::array<std::string, 3> values;     // texts in the pixel; empty: none
};

struct Lens {
    glm::ivec2 corner{0};  // the upper left pixel in the picture
    glm::ivec2 extent{0};  // 0: no lens
    std::vector<LensPixel> pixels;
    std::string values;    // what the numbers mean, such as "sRGB"
    bool flipped = false;  // are these pixels those of the reference?
};

/// The number of pixels from the middle of the lens to its edge.
int lens_radius(LensZoom zoom);

/// Draws the lens in the lower left corner of the picture's area, or in the right corner if it would hide the
/// picked pixel. Frames the picked pixel. Returns the height that the lens takes in the left corner.
float draw_lens(ImDrawList& list, const Rect& area, const Lens& lens, LensZoom zoom, glm::ivec2 pixel,
                const Palette& colors);

/// Draws text on its own background, with the upper left corner at `at`.
void draw_label(ImDrawList& list, ImVec2 at, const std::string& text, const Palette& colors);

}  // namespace momentscope::ui
