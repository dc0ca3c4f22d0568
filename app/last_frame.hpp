// last_frame.hpp -- what the window showed last, to be shown again while the next frame is being drawn.
#pragma once
#include <glm/glm.hpp>

#include "core/gl/handle.hpp"

namespace momentscope {

class LastFrame {
public:
    /// Copies the default framebuffer, of that size, before its buffers are swapped.
    void keep(glm::ivec2 size);

    /// Copies it back, stretched to another size; black when none was kept.
    void show(glm::ivec2 size) const;

private:
    GlTexture color_;
    GlFramebuffer target_;
    glm::ivec2 size_{0};
};

}  // namespace momentscope
