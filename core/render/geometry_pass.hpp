// geometry_pass.hpp -- draws the transparent surfaces in front of the opaque ones once.
#pragma once
#include "core/gl/gl_info.hpp"
#include "core/gl/program.hpp"
#include "core/render/scene_buffers.hpp"

namespace momentscope {

/// How the output of a fragment is written: it replaces the stored value, is added to it, is composited over
/// it, or is stored if it is greater.
enum class Blending { none, add, over, greatest };

/// Draws into `target` with the program in use. Depth is tested, but not written. Afterwards blending and
/// depth test are off.
void draw_transparent(const SceneBuffers& scene, GLuint target, Blending blending);

/// Like draw_transparent, but keeps only the fragment with the least depth in each pixel; if several have it,
/// the latest. Writes depth.
void draw_nearest(const SceneBuffers& scene, GLuint target);

/// Sets the first `color_count` colours of a framebuffer to 0.
void clear_colors(GLuint target, int color_count);

/// Unbinds program and framebuffer. Code that draws next may restore what it found bound, so this must not be
/// something that was deleted.
void leave_nothing_bound();

/// Defines the macro for the access by which a shader reads and writes in order; with none, it blends.
void define_access(ShaderVariant& variant, OrderedAccess access);

}  // namespace momentscope
