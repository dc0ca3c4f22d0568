// egl_context.hpp -- draws without a display by EGL, on a GPU if there is one. CMake chooses egl_context.cpp
// or no_egl_context.cpp (MOMENTSCOPE_EGL).
#pragma once
#include "app/gl_context.hpp"

namespace momentscope {

/// False if the program was built without EGL.
extern const bool HAS_EGL;

/// A context with a default framebuffer of this size. Tries the GPUs of the system, then the default display,
/// then Mesa's rendering without a surface. Throws Error that names what was tried; it always does so if the
/// program was built without EGL.
std::unique_ptr<GlContext> make_egl_context(glm::ivec2 size);

/// The same with OpenGL ES 3.0.
std::unique_ptr<GlContext> make_egl_es_context(glm::ivec2 size);

/// True if EGL can be loaded and lists a GPU.
bool has_egl_gpu();

}  // namespace momentscope
