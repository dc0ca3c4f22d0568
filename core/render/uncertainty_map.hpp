// uncertainty_map.hpp -- how much of a pixel's luminance the moments leave open, for all pixels of a picture.
#pragma once
#include <vector>

#include "core/render/drawn_picture.hpp"

namespace momentscope {

class UncertaintyMap {
public:
    /// size: of the picture. depth: the texture of its opaque depths.
    UncertaintyMap(glm::ivec2 size, GLuint depth);

    /// The sum over the fragments of each pixel of opacity, luminance and (T high - T low), row by row from
    /// the top; the GPU's counterpart of color_uncertainty. Empty, and nothing is drawn, if the technique
    /// reconstructs nothing.
    std::vector<float> draw(const DrawnPicture& picture);

private:
    GlTexture sums_;
    GlFramebuffer target_;
};

}  // namespace momentscope
