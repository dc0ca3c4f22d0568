// geometry_pass.hpp -- draws the transparent surfaces in front of the opaque ones once.
#pragma once
#include "core/gl/capabilities.hpp"
#include "core/gl/draw_state.hpp"
#include "core/gl/framebuffer.hpp"
#include "core/gl/program.hpp"
#include "core/render/scene_buffers.hpp"

namespace momentscope {

/// Draws into `target` with the program in use. Depth is tested, but not written, whatever the state says.
void draw_transparent(const SceneBuffers& scene, GLuint target, DrawState state);

/// Like draw_transparent, but keeps only the fragment with the least depth in each pixel; if several have it,
/// the latest. Writes depth.
void draw_nearest(const SceneBuffers& scene, GLuint target);

/// Unbinds program and framebuffer. Code that draws next may restore what it found bound, so this must not be
/// something that was deleted.
void leave_nothing_bound();

/// Framebuffers that draw to these textures, in groups of at most `most` colour targets.
std::vector<GlFramebuffer> make_group_framebuffers(const std::vector<GlTexture>& colors, GLuint depth,
                                                   int most);

/// Tells a shader that writes `count` texels to which of them a group belongs, if there are several groups.
void define_group(ShaderVariant& variant, std::size_t group, std::size_t count, int most);

/// Defines the macro for the access by which a shader reads and writes in order; with none, it blends.
void define_access(ShaderVariant& variant, OrderedAccess access);

}  // namespace momentscope
