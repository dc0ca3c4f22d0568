// framebuffer.hpp -- what is drawn to: making, binding, clearing, copying.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <initializer_list>
#include <vector>

#include "core/gl/texture.hpp"

namespace momentscope {

constexpr int MOST_COLOR_TARGETS = 8;  // of a framebuffer; a GL may have fewer

/// A framebuffer that draws to the colour textures in this order, and tests depth if depth != 0. Throws Error
/// if this GL cannot render to them.
GlFramebuffer make_framebuffer(std::initializer_list<GLuint> colors, GLuint depth);
GlFramebuffer make_framebuffer(const std::vector<GLuint>& colors, GLuint depth);

/// A framebuffer that also counts in the stencil of a GL_DEPTH24_STENCIL8 texture.
GlFramebuffer make_counting_framebuffer(std::initializer_list<GLuint> colors, GLuint stencil);

/// A framebuffer that draws to `count` layers of an array texture, from `first` on.
GlFramebuffer make_layer_framebuffer(GLuint layered, int first, int count);

/// Everything is drawn to this framebuffer from now on. 0: the window.
void bind_framebuffer(GLuint framebuffer);

/// Sets one colour of all pixels. Floats and integers must suit the format of the texture.
void clear_color(GLuint framebuffer, int color, const glm::vec4& value);
void clear_color(GLuint framebuffer, int color, const glm::uvec4& value);

/// The same within a rectangle.
void clear_color(GLuint framebuffer, int color, const glm::vec4& value, const TexelRect& rect);
void clear_color(GLuint framebuffer, int color, const glm::uvec4& value, const TexelRect& rect);

/// Sets what the stencil counts in a rectangle to 0.
void clear_stencil(GLuint framebuffer, const TexelRect& rect);

/// Sets the first `count` colours to 0.
void clear_colors(GLuint framebuffer, int count);

void clear_depth(GLuint framebuffer, float depth);

/// Copies the depths of all pixels between framebuffers of one size and one format.
void copy_depth(GLuint from, GLuint to, glm::ivec2 size);

/// Copies the colour of a framebuffer, scaled if sizes differ.
void copy_color(GLuint from, glm::ivec2 from_size, GLuint to, glm::ivec2 to_size);

/// Binds the window and makes all of it black.
void clear_window(glm::ivec2 size);

/// The content of the window as sRGB RGBA bytes, row by row from the top.
std::vector<unsigned char> read_window(glm::ivec2 size);

}  // namespace momentscope
