#include "core/gl/texture.hpp"

#include <fmt/format.h>

#include <array>

#include "core/support/error.hpp"

namespace momentscope {

namespace {

void use_without_filter(GLuint texture) {
    glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

}  // namespace

GlTexture make_texture(GLenum format, glm::ivec2 size) {
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &name);
    GlTexture texture(name);
    glTextureStorage2D(texture, 1, format, size.x, size.y);
    check_gl(fmt::format("making a texture of {}x{} pixels", size.x, size.y));
    use_without_filter(texture);
    return texture;
}

GlTexture make_layered_texture(GLenum format, glm::ivec2 size, int layers) {
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &name);
    GlTexture texture(name);
    glTextureStorage3D(texture, 1, format, size.x, size.y, layers);
    check_gl(fmt::format("making {} textures of {}x{} pixels", layers, size.x, size.y));
    use_without_filter(texture);
    return texture;
}

GlFramebuffer make_framebuffer(std::initializer_list<GLuint> colors, GLuint depth) {
    return make_framebuffer(colors.begin(), static_cast<int>(colors.size()), depth);
}

namespace {

// Calls attach(framebuffer, attachment, i) for each colour.
template <typename Attach>
GlFramebuffer make_framebuffer_of(int count, GLuint depth, const Attach& attach) {
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    GlFramebuffer framebuffer(name);
    std::array<GLenum, 8> attachments{};
    for (int i = 0; i < count; ++i) {
        attachments[static_cast<std::size_t>(i)] = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
        attach(name, attachments[static_cast<std::size_t>(i)], i);
    }
    if (depth != 0) glNamedFramebufferTexture(framebuffer, GL_DEPTH_ATTACHMENT, depth, 0);
    glNamedFramebufferDrawBuffers(framebuffer, count, attachments.data());
    const GLenum status = glCheckNamedFramebufferStatus(framebuffer, GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw Error(
            fmt::format("This GL cannot render to the textures that are needed (status 0x{:x}); it must have "
                        "OpenGL 4.5 with float render targets.",
                        status));
    return framebuffer;
}

}  // namespace

GlFramebuffer make_framebuffer(const GLuint* colors, int count, GLuint depth) {
    return make_framebuffer_of(count, depth, [&](GLuint framebuffer, GLenum attachment, int i) {
        glNamedFramebufferTexture(framebuffer, attachment, colors[i], 0);
    });
}

GlFramebuffer make_layer_framebuffer(GLuint layered, int first, int count) {
    return make_framebuffer_of(count, 0, [&](GLuint framebuffer, GLenum attachment, int i) {
        glNamedFramebufferTextureLayer(framebuffer, attachment, layered, 0, first + i);
    });
}

void check_gl(const std::string& doing) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) return;
    if (error == GL_OUT_OF_MEMORY)
        throw Error(fmt::format("Graphics memory ran out while {}; try a smaller --size.", doing));
    throw Error(fmt::format("GL reported error 0x{:x} while {}; please report this as a bug.", error, doing));
}

}  // namespace momentscope
