#include "app/last_frame.hpp"

#include "core/gl/framebuffer.hpp"

namespace momentscope {

void LastFrame::keep(glm::ivec2 size) {
    if (size != size_) {
        color_ = make_texture(GL_RGBA8, size);
        target_ = make_framebuffer({color_}, 0);
        size_ = size;
    }
    copy_color(0, size, target_, size);
}

void LastFrame::show(glm::ivec2 size) const {
    clear_window(size);
    if (size_.x > 0) copy_color(target_, size_, 0, size);
}

}  // namespace momentscope
