// last_frame.hpp -- keeps the last frame of the window, to show it again while the next one is drawn.
#pragma once
#include <glm/glm.hpp>

#include "core/gl/handle.hpp"

namespace momentscope {

class LastFrame {
public:
    /// Copies the default framebuffer of this size. Call it before the buffers are swapped.
    void keep(glm::ivec2 size);

    /// Copies the frame back, stretched if the size differs; black if no frame was kept.
    void show(glm::ivec2 size) const;

private:
    GlTexture color_;
    GlFramebuffer target_;
    glm::ivec2 size_{0};
};

}  // namespace momentscope
