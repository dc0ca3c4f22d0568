// osmesa_context.hpp -- draws without a display, in software. CMake chooses osmesa_context.cpp or
// no_osmesa_context.cpp (MOMENTSCOPE_OSMESA).
#pragma once
#include "app/gl_context.hpp"

namespace momentscope {

/// False if the program was built without OSMesa.
extern const bool HAS_OSMESA;

/// A context with a default framebuffer of this size. Throws Error that says what to do; it always does so if
/// the program was built without OSMesa.
std::unique_ptr<GlContext> make_osmesa_context(glm::ivec2 size);

}  // namespace momentscope
