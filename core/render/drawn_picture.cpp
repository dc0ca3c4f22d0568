#include "core/render/drawn_picture.hpp"

#include "core/gl/buffer.hpp"
#include "core/gl/draw_state.hpp"
#include "core/scene/camera.hpp"

namespace momentscope {

void DrawnPicture::bind() const {
    set_viewport(view.size);
    bind_uniforms(0, frame_block);
    if (shadows != nullptr) shadows->bind(view_matrix(view.camera));
}

}  // namespace momentscope
