// lens_content.hpp -- the content of the lens: the visible pixels and their values.
#pragma once
#include "ui/picture/picture_comparison.hpp"
#include "ui/picture/pixel_lens.hpp"

namespace momentscope::ui {

struct LensInput {
    glm::ivec2 middle;  // the picked pixel
    glm::ivec2 size;    // of the picture
    bool map;           // is a map of differences shown instead of the picture?
    bool changed;       // did the pixels change since the last frame?
};

/// Reads pixels back only if the content of the lens changed.
void update_lens(Lens& lens, const Update& update, const Renderer& renderer,
                 const PictureComparison& comparison, const LensInput& input);

}  // namespace momentscope::ui
