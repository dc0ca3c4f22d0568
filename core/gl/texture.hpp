// texture.hpp -- textures with one level: making, writing, reading, binding.
//
// Everything that the program asks of the GL is a function of core/gl. The functions bind what they change,
// as OpenGL 4.1 and OpenGL ES 3.0 need it, and promise nothing about what is bound afterwards, except where a
// name says so.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/gl/handle.hpp"

namespace momentscope {

/// A texture with one level and without filtering. Its contents are undefined. format: a sized format, such
/// as GL_RGBA32F. Throws Error if there is not enough memory.
GlTexture make_texture(GLenum format, glm::ivec2 size);

/// The same with `layers` layers.
GlTexture make_layered_texture(GLenum format, glm::ivec2 size, int layers);

/// Replaces all texels, row by row. format, type: of the data, such as GL_RGBA and GL_UNSIGNED_BYTE. Rows
/// need no alignment.
void write_texture(GLuint texture, glm::ivec2 size, GLenum format, GLenum type, const void* texels);

/// Interpolates between texels, and repeats the texture beyond its edges.
void interpolate_and_repeat(GLuint texture);

/// A rectangle of pixels or texels, counted from the lower left.
struct TexelRect {
    glm::ivec2 corner{0};
    glm::ivec2 extent{0};
};

/// The first `channels` numbers of each texel of a rectangle, row by row. The GL must be able to render to
/// the texture.
std::vector<float> read_texture(GLuint texture, const TexelRect& rect, int channels);

/// All four numbers of each texel of a rectangle, row by row; those that the texture lacks are 0, 0 and 1.
std::vector<glm::vec4> read_colors(GLuint texture, const TexelRect& rect);

/// The same from one layer.
std::vector<glm::vec4> read_layer_colors(GLuint layered, int layer, const TexelRect& rect);

/// The bytes of a GL_RGBA8 texture.
std::vector<unsigned char> read_texture_bytes(GLuint texture, glm::ivec2 size);

/// Binds a texture to a unit for samplers. 0: none.
void bind_texture(GLuint unit, GLuint texture);
void bind_layered_texture(GLuint unit, GLuint texture);

/// Binds a texture to a unit for image access, with all of its layers. Needs OpenGL 4.2.
void bind_image(GLuint unit, GLuint texture, GLenum format);

/// Throws Error if the GL reported an error since the last call. `doing` completes the sentence "... failed
/// while <doing>".
void check_gl(const std::string& doing);

}  // namespace momentscope
