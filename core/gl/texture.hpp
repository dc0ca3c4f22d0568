// texture.hpp -- makes render targets.
#pragma once
#include <glm/glm.hpp>
#include <initializer_list>
#include <string>

#include "core/gl/handle.hpp"

namespace momentscope {

/// A texture with one level and without filtering. Its contents are undefined. format: a sized format, such
/// as GL_RGBA32F. Throws Error if there is not enough memory.
GlTexture make_texture(GLenum format, glm::ivec2 size);

/// The same with `layers` layers.
GlTexture make_layered_texture(GLenum format, glm::ivec2 size, int layers);

/// A framebuffer that draws to the colour textures in this order, and tests depth if depth != 0. Throws Error
/// if this GL cannot render to them.
GlFramebuffer make_framebuffer(std::initializer_list<GLuint> colors, GLuint depth);
GlFramebuffer make_framebuffer(const GLuint* colors, int count, GLuint depth);

/// A framebuffer that draws to `count` layers of an array texture, from `first` on.
GlFramebuffer make_layer_framebuffer(GLuint layered, int first, int count);

/// Throws Error if the GL reported an error since the last call. `doing` completes the sentence "... failed
/// while <doing>".
void check_gl(const std::string& doing);

}  // namespace momentscope
