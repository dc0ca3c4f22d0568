// fragment_capture.hpp -- captures the exact fragments of pixels of the last picture.
#pragma once
#include <vector>

#include "core/inspect/pixel_capture.hpp"
#include "core/render/drawn_picture.hpp"
#include "core/render/fragment_list.hpp"

namespace momentscope {

class FragmentCapture {
public:
    /// size: of the picture. depth: the texture of its opaque depths.
    FragmentCapture(glm::ivec2 size, GLuint depth, const Capabilities& gl);

    /// The fragments of a rectangle, row by row. corner: its upper left. Throws Error if a low-resolution
    /// technique mixes more fragments than can be captured.
    std::vector<PixelCapture> region(const DrawnPicture& picture, glm::ivec2 corner, glm::ivec2 extent);

    /// The share of the light that reaches each fragment of a pixel. The picture must have shadows.
    std::vector<float> lights(const DrawnPicture& picture, glm::ivec2 pixel);

private:
    FragmentSource& source();

    glm::ivec2 size_;
    GLuint depth_;
    Capabilities gl_;
    std::unique_ptr<FragmentSource> source_;  // made at first use
};

}  // namespace momentscope
