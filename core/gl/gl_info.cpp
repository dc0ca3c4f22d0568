#include "core/gl/gl_info.hpp"

#include <fmt/format.h>
#include <glad/gl.h>

#include <algorithm>
#include <string_view>

#include "core/support/error.hpp"

namespace momentscope {

namespace {

std::string gl_text(GLenum name) {
    const GLubyte* text = glGetString(name);
    return text == nullptr ? "unknown" : reinterpret_cast<const char*>(text);
}

int gl_number(GLenum name) {
    GLint number = 0;
    glGetIntegerv(name, &number);
    return number;
}

bool has_extension(std::string_view wanted) {
    const int count = gl_number(GL_NUM_EXTENSIONS);
    for (int i = 0; i < count; ++i)
        if (wanted == reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i))))
            return true;
    return false;
}

}  // namespace

OrderedAccess ordered_access() {
    if (has_extension("GL_ARB_fragment_shader_interlock")) return OrderedAccess::interlock;
    if (has_extension("GL_EXT_shader_framebuffer_fetch")) return OrderedAccess::framebuffer_fetch;
    return OrderedAccess::none;
}

GlInfo gl_info() {
    GlInfo info;
    info.renderer = gl_text(GL_RENDERER);
    info.version = gl_text(GL_VERSION);
    info.software =
        std::ranges::any_of(std::initializer_list<const char*>{"llvmpipe", "softpipe", "SWR"},
                            [&](const char* name) { return info.renderer.find(name) != std::string::npos; });
    if (info.software)
        info.missing.push_back(
            {"a GPU", "pictures are drawn by the CPU, so times say nothing about graphics hardware"});
    switch (ordered_access()) {
        case OrderedAccess::interlock:
            break;
        case OrderedAccess::framebuffer_fetch:
            info.missing.push_back({"fragment shader interlock",
                                    "framebuffer fetch takes its place: 16-bit variants run, but at other "
                                    "speeds than with rasterizer ordered views"});
            break;
        case OrderedAccess::none:
            info.missing.push_back({"fragment shader interlock and framebuffer fetch",
                                    "methods that read, change and write a pixel in order cannot run: all "
                                    "16-bit variants, and ordered accumulation"});
    }
    if (!has_extension("GL_NV_shader_atomic_int64"))
        info.missing.push_back(
            {"64-bit atomics in shaders", "methods that sort fragments by atomics cannot run"});
    const std::size_t block = most_bytes_of_storage();
    constexpr std::size_t WHOLE_PICTURE = 120'000'000;  // bytes of the list that `sorted` needs
    if (block < WHOLE_PICTURE)
        info.missing.push_back({fmt::format("shader buffers beyond {} MB", block / 1'000'000),
                                "sorted draws large pictures in more bands, which takes longer"});
    return info;
}

void require_supported_gl() {
    const int major = gl_number(GL_MAJOR_VERSION), minor = gl_number(GL_MINOR_VERSION);
    if (major * 10 + minor < 45)
        throw Error(fmt::format(
            "This GL is version {}.{}, but Momentscope needs OpenGL 4.5; update the driver, or use "
            "--headless, which renders in software.",
            major, minor));
}

int most_texels_of_a_side() {
    return gl_number(GL_MAX_TEXTURE_SIZE);
}

int most_texture_layers() {
    return gl_number(GL_MAX_ARRAY_TEXTURE_LAYERS);
}

std::size_t most_bytes_of_storage() {
    GLint64 bytes = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    return static_cast<std::size_t>(bytes);
}

}  // namespace momentscope
