// geometry_pass.hpp -- the transparent surfaces in front of the opaque ones, drawn once.
#pragma once
#include "core/gl/gl_info.hpp"
#include "core/gl/program.hpp"
#include "core/render/scene_buffers.hpp"

namespace momentscope {

/// What becomes of a fragment's outputs: they take the place of what is there, are added to it, or put over
/// it.
enum class Blending { none, add, over };

/// Draws with the program in use into `target`, whose depth is tested and not written. Leaves blending and
/// depth test off.
void draw_transparent(const SceneBuffers& scene, GLuint target, Blending blending);

/// The same, but of all fragments of a pixel that with the least depth stays, and of such the latest; writes
/// depth.
void draw_nearest(const SceneBuffers& scene, GLuint target);

/// Zeros in the first `color_count` colours of a framebuffer.
void clear_colors(GLuint target, int color_count);

/// What draws next may put back what it found, which must then still exist.
void leave_nothing_bound();

/// Tells a shader by which access it reads and writes in order; by none it is blended.
void define_access(ShaderVariant& variant, OrderedAccess access);

}  // namespace momentscope
