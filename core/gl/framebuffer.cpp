#include "core/gl/framebuffer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/gtc/type_ptr.hpp>

#include "core/gl/draw_state.hpp"
#include "core/support/error.hpp"

namespace momentscope {

namespace {

// Calls attach(attachment, i) for each colour.
template <typename Attach>
GlFramebuffer make_framebuffer_of(int count, GLuint depth, const Attach& attach,
                                  GLenum depth_attachment = GL_DEPTH_ATTACHMENT) {
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    GlFramebuffer framebuffer(name);
    bind_framebuffer(name);
    std::array<GLenum, MOST_COLOR_TARGETS> attachments{};
    for (int i = 0; i < count; ++i) {
        attachments[static_cast<std::size_t>(i)] = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
        attach(attachments[static_cast<std::size_t>(i)], i);
    }
    if (depth != 0) glFramebufferTexture2D(GL_FRAMEBUFFER, depth_attachment, GL_TEXTURE_2D, depth, 0);
    glDrawBuffers(count, attachments.data());
    if (count == 0) glReadBuffer(GL_NONE);  // some GLs call a framebuffer without it incomplete
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    bind_framebuffer(0);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw Error(
            fmt::format("This GL cannot render to the textures that are needed (status 0x{:x}); it must have "
                        "OpenGL 3.3 or OpenGL ES 3.0, with float render targets.",
                        status));
    return framebuffer;
}

GlFramebuffer make_framebuffer(const GLuint* colors, std::size_t count, GLuint depth) {
    return make_framebuffer_of(static_cast<int>(count), depth, [&](GLenum attachment, int i) {
        glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, colors[i], 0);
    });
}

void blit(GLuint from, glm::ivec2 from_size, GLuint to, glm::ivec2 to_size, GLbitfield what) {
    set_draw_state({});
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    glBlitFramebuffer(0, 0, from_size.x, from_size.y, 0, 0, to_size.x, to_size.y, what,
                      from_size == to_size ? GL_NEAREST : GL_LINEAR);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
}

// Clears honour the scissor and the depth mask.
void bind_for_clear(GLuint framebuffer, const std::optional<TexelRect>& rect) {
    set_draw_state({.scissor = rect});
    bind_framebuffer(framebuffer);
}

}  // namespace

GlFramebuffer make_framebuffer(std::initializer_list<GLuint> colors, GLuint depth) {
    return make_framebuffer(colors.begin(), colors.size(), depth);
}

GlFramebuffer make_framebuffer(const std::vector<GLuint>& colors, GLuint depth) {
    return make_framebuffer(colors.data(), colors.size(), depth);
}

GlFramebuffer make_counting_framebuffer(std::initializer_list<GLuint> colors, GLuint stencil) {
    const auto attach = [&](GLenum attachment, int i) {
        glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, colors.begin()[i], 0);
    };
    return make_framebuffer_of(static_cast<int>(colors.size()), stencil, attach, GL_DEPTH_STENCIL_ATTACHMENT);
}

GlFramebuffer make_layer_framebuffer(GLuint layered, int first, int count) {
    return make_framebuffer_of(count, 0, [&](GLenum attachment, int i) {
        glFramebufferTextureLayer(GL_FRAMEBUFFER, attachment, layered, 0, first + i);
    });
}

void bind_framebuffer(GLuint framebuffer) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

void clear_color(GLuint framebuffer, int color, const glm::vec4& value) {
    bind_for_clear(framebuffer, {});
    glClearBufferfv(GL_COLOR, color, glm::value_ptr(value));
}

void clear_color(GLuint framebuffer, int color, const glm::uvec4& value) {
    bind_for_clear(framebuffer, {});
    glClearBufferuiv(GL_COLOR, color, glm::value_ptr(value));
}

void clear_color(GLuint framebuffer, int color, const glm::vec4& value, const TexelRect& rect) {
    bind_for_clear(framebuffer, rect);
    glClearBufferfv(GL_COLOR, color, glm::value_ptr(value));
}

void clear_stencil(GLuint framebuffer, const TexelRect& rect) {
    bind_for_clear(framebuffer, rect);
    constexpr GLint NOTHING = 0;
    glClearBufferiv(GL_STENCIL, 0, &NOTHING);
}

void clear_color(GLuint framebuffer, int color, const glm::uvec4& value, const TexelRect& rect) {
    bind_for_clear(framebuffer, rect);
    glClearBufferuiv(GL_COLOR, color, glm::value_ptr(value));
}

void clear_colors(GLuint framebuffer, int count) {
    for (int i = 0; i < count; ++i) clear_color(framebuffer, i, glm::vec4(0));
}

void clear_depth(GLuint framebuffer, float depth) {
    bind_for_clear(framebuffer, {});
    glClearBufferfv(GL_DEPTH, 0, &depth);
}

void copy_depth(GLuint from, GLuint to, glm::ivec2 size) {
    blit(from, size, to, size, GL_DEPTH_BUFFER_BIT);
}

void copy_color(GLuint from, glm::ivec2 from_size, GLuint to, glm::ivec2 to_size) {
    blit(from, from_size, to, to_size, GL_COLOR_BUFFER_BIT);
}

void clear_window(glm::ivec2 size) {
    bind_for_clear(0, {});
    set_viewport(size);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

std::vector<unsigned char> read_window(glm::ivec2 size) {
    const std::size_t row = static_cast<std::size_t>(size.x) * 4;
    std::vector<unsigned char> pixels(row * static_cast<std::size_t>(size.y));
    bind_framebuffer(0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    for (std::size_t y = 0; y < static_cast<std::size_t>(size.y) / 2; ++y)
        std::swap_ranges(pixels.begin() + static_cast<std::ptrdiff_t>(y * row),
                         pixels.begin() + static_cast<std::ptrdiff_t>((y + 1) * row),
                         pixels.end() - static_cast<std::ptrdiff_t>((y + 1) * row));
    return pixels;
}

}  // namespace momentscope
