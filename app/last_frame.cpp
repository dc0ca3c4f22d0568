#include "app/last_frame.hpp"

#include "core/gl/texture.hpp"

namespace momentscope {

void LastFrame::keep(glm::ivec2 size) {
    if (size != size_) {
        color_ = make_texture(GL_RGBA8, size);
        target_ = make_framebuffer({color_}, 0);
        size_ = size;
    }
    glBlitNamedFramebuffer(0, target_, 0, 0, size.x, size.y, 0, 0, size.x, size.y, GL_COLOR_BUFFER_BIT,
                           GL_NEAREST);
}

void LastFrame::show(glm::ivec2 size) const {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, size.x, size.y);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    if (size_.x > 0)
        glBlitNamedFramebuffer(target_, 0, 0, 0, size_.x, size_.y, 0, 0, size.x, size.y, GL_COLOR_BUFFER_BIT,
                               size == size_ ? GL_NEAREST : GL_LINEAR);
}

}  // namespace momentscope
