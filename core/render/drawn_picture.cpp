#include "core/render/drawn_picture.hpp"

#include "core/scene/camera.hpp"

namespace momentscope {

void DrawnPicture::bind() const {
    glViewport(0, 0, view.size.x, view.size.y);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, frame_block);
    if (shadows != nullptr) shadows->bind(view_matrix(view.camera));
}

}  // namespace momentscope
