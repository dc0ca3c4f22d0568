#include "app/egl_context.hpp"
#include "core/support/error.hpp"

namespace momentscope {

const bool HAS_EGL = false;

bool has_egl_gpu() {
    return false;
}

std::unique_ptr<GlContext> make_egl_context(glm::ivec2 /*size*/) {
    throw Error("This program was built without EGL; build it with the CMake option MOMENTSCOPE_EGL=ON.");
}

std::unique_ptr<GlContext> make_egl_es_context(glm::ivec2 size) {
    return make_egl_context(size);
}

}  // namespace momentscope
