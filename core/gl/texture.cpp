#include "core/gl/texture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>

#include "core/support/error.hpp"

namespace momentscope {

namespace {

// Textures are edited at this unit, which no shader reads. OpenGL ES 3.0 has at least 32.
constexpr GLenum EDITING_UNIT = GL_TEXTURE31;

void edit(GLenum target, GLuint texture) {
    glActiveTexture(EDITING_UNIT);
    glBindTexture(target, texture);
}

void set(GLenum target, GLenum filter, GLenum wrap) {
    const auto filtered = static_cast<GLint>(filter), wrapped = static_cast<GLint>(wrap);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, filtered);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, filtered);
    glTexParameteri(target, GL_TEXTURE_WRAP_S, wrapped);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, wrapped);
    glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);  // there are no smaller copies
}

GlTexture new_texture() {
    GLuint name = 0;
    glGenTextures(1, &name);
    return GlTexture(name);
}

/// What glTexImage2D must be told of a sized format, although it gets no texels.
struct TexelFormat {
    GLenum format, channels, type;
};

constexpr TexelFormat TEXEL_FORMATS[] = {
    {GL_R8, GL_RED, GL_UNSIGNED_BYTE},
    {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE},
    {GL_RG16, GL_RG, GL_UNSIGNED_SHORT},
    {GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT},
    {GL_R16F, GL_RED, GL_HALF_FLOAT},
    {GL_RG16F, GL_RG, GL_HALF_FLOAT},
    {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT},
    {GL_R32F, GL_RED, GL_FLOAT},
    {GL_RG32F, GL_RG, GL_FLOAT},
    {GL_RGBA32F, GL_RGBA, GL_FLOAT},
    {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT},
    {GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT},
    {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT},
    {GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8},
};

const TexelFormat& texel_format(GLenum format) {
    const auto* found = std::ranges::find(TEXEL_FORMATS, format, &TexelFormat::format);
    assert(found != std::end(TEXEL_FORMATS) && "an unknown format of textures");
    return *found;
}

// A framebuffer to read from.
class Reading {
public:
    explicit Reading(GLuint texture) : Reading() {
        glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    }
    Reading(GLuint layered, int layer) : Reading() {
        glFramebufferTextureLayer(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, layered, 0, layer);
    }
    ~Reading() { glBindFramebuffer(GL_READ_FRAMEBUFFER, 0); }
    Reading(const Reading&) = delete;
    Reading& operator=(const Reading&) = delete;

    static void read(const TexelRect& rect, GLenum format, GLenum type, void* texels) {
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(rect.corner.x, rect.corner.y, rect.extent.x, rect.extent.y, format, type, texels);
        glPixelStorei(GL_PACK_ALIGNMENT, 4);
    }

private:
    Reading() {
        GLuint name = 0;
        glGenFramebuffers(1, &name);
        framebuffer_ = GlFramebuffer(name);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, name);
    }

    GlFramebuffer framebuffer_;
};

std::size_t texel_count(glm::ivec2 extent) {
    return static_cast<std::size_t>(extent.x) * static_cast<std::size_t>(extent.y);
}

std::vector<glm::vec4> read_bound_colors(const TexelRect& rect) {
    std::vector<glm::vec4> colors(texel_count(rect.extent));
    Reading::read(rect, GL_RGBA, GL_FLOAT, colors.data());
    return colors;
}

}  // namespace

GlTexture make_texture(GLenum format, glm::ivec2 size) {
    GlTexture texture = new_texture();
    edit(GL_TEXTURE_2D, texture);
    const TexelFormat& texel = texel_format(format);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), size.x, size.y, 0, texel.channels, texel.type,
                 nullptr);
    check_gl(fmt::format("making a texture of {}x{} pixels", size.x, size.y));
    set(GL_TEXTURE_2D, GL_NEAREST, GL_CLAMP_TO_EDGE);
    return texture;
}

GlTexture make_layered_texture(GLenum format, glm::ivec2 size, int layers) {
    GlTexture texture = new_texture();
    edit(GL_TEXTURE_2D_ARRAY, texture);
    const TexelFormat& texel = texel_format(format);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, static_cast<GLint>(format), size.x, size.y, layers, 0,
                 texel.channels, texel.type, nullptr);
    check_gl(fmt::format("making {} textures of {}x{} pixels", layers, size.x, size.y));
    set(GL_TEXTURE_2D_ARRAY, GL_NEAREST, GL_CLAMP_TO_EDGE);
    return texture;
}

void write_texture(GLuint texture, glm::ivec2 size, GLenum format, GLenum type, const void* texels) {
    edit(GL_TEXTURE_2D, texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.x, size.y, format, type, texels);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

void interpolate_and_repeat(GLuint texture) {
    edit(GL_TEXTURE_2D, texture);
    set(GL_TEXTURE_2D, GL_LINEAR, GL_REPEAT);
}

std::vector<float> read_texture(GLuint texture, const TexelRect& rect, int channels) {
    const auto count = static_cast<std::size_t>(channels);
    std::vector<float> numbers;
    numbers.reserve(texel_count(rect.extent) * count);
    for (const glm::vec4& color : read_colors(texture, rect))
        for (int i = 0; i < channels; ++i) numbers.push_back(color[i]);
    return numbers;
}

std::vector<glm::vec4> read_colors(GLuint texture, const TexelRect& rect) {
    const Reading reading(texture);
    return read_bound_colors(rect);
}

std::vector<glm::vec4> read_layer_colors(GLuint layered, int layer, const TexelRect& rect) {
    const Reading reading(layered, layer);
    return read_bound_colors(rect);
}

std::vector<unsigned char> read_texture_bytes(GLuint texture, glm::ivec2 size) {
    const Reading reading(texture);
    std::vector<unsigned char> bytes(4 * texel_count(size));
    Reading::read({{0, 0}, size}, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    return bytes;
}

void bind_texture(GLuint unit, GLuint texture) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, texture);
}

void bind_layered_texture(GLuint unit, GLuint texture) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
}

void bind_image(GLuint unit, GLuint texture, GLenum format) {
    glBindImageTexture(unit, texture, 0, GL_TRUE, 0, GL_READ_WRITE, format);
}

void check_gl(const std::string& doing) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) return;
    if (error == GL_OUT_OF_MEMORY)
        throw Error(fmt::format("Graphics memory ran out while {}; try a smaller --size.", doing));
    throw Error(fmt::format("GL reported error 0x{:x} while {}; please report this as a bug.", error, doing));
}

}  // namespace momentscope
