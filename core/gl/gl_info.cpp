#include "core/gl/gl_info.hpp"

#include <fmt/format.h>
#include <glad/gl.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace momentscope {

namespace {

std::string gl_text(GLenum name) {
    const GLubyte* text = glGetString(name);
    return text == nullptr ? "unknown" : reinterpret_cast<const char*>(text);
}

// The renderer. A browser names it only by an extension.
std::string renderer_name() {
    constexpr GLenum UNMASKED_RENDERER_WEBGL = 0x9246;
    return gl_text(has_gl_extension("WEBGL_debug_renderer_info") ? UNMASKED_RENDERER_WEBGL : GL_RENDERER);
}

int gl_number(GLenum name) {
    GLint number = 0;
    glGetIntegerv(name, &number);
    return number;
}

}  // namespace

GlVersion gl_version() {
    const GLubyte* text = glGetString(GL_VERSION);
    if (text == nullptr) return {};
    const bool embedded = std::string_view(reinterpret_cast<const char*>(text)).starts_with("OpenGL ES");
    return {embedded, gl_number(GL_MAJOR_VERSION), gl_number(GL_MINOR_VERSION)};
}

bool has_gl_extension(std::string_view name) {
    const int count = gl_number(GL_NUM_EXTENSIONS);
    for (int i = 0; i < count; ++i)
        if (name == reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i))))
            return true;
    return false;
}

GlInfo gl_info(const Capabilities& can) {
    GlInfo info;
    info.renderer = renderer_name();
    info.version = gl_text(GL_VERSION);
    info.can = can;
    info.software =
        std::ranges::any_of(std::initializer_list<const char*>{"llvmpipe", "softpipe", "SWR", "SwiftShader"},
                            [&](const char* name) { return info.renderer.find(name) != std::string::npos; });
    const auto missing = [&](bool is, std::string feature, std::string consequence) {
        if (is) info.missing.push_back({std::move(feature), std::move(consequence)});
    };
    missing(info.software, "a GPU",
            "pictures are drawn by the CPU, so times say nothing about graphics hardware");
    missing(!can.storage, "buffers and images that shaders write",
            "fragments are captured layer by layer, which takes longer, and methods that store samples by "
            "atomic operations cannot run");
    missing(can.ordered == OrderedAccess::framebuffer_fetch, "fragment shader interlock",
            "framebuffer fetch takes its place, at other speeds than those of rasterizer ordered views");
    missing(can.ordered == OrderedAccess::none, "fragment shader interlock and framebuffer fetch",
            "methods that read, change and write a pixel in order cannot run: all 16-bit variants, and "
            "ordered accumulation");
    missing(!can.unorm16, "render targets of 16-bit numbers in [0, 1]",
            "the ends of a ray take 64 bits of a pixel instead of 32, and 16-bit variants cannot run");
    missing(!can.timer_queries, "timer queries", "a clock measures the times of passes");
    missing(can.language.rounding == Rounding::guarded,
            "a word that keeps the order of operations in shaders",
            "the results of operations are hidden from the driver instead, which takes longer");
    missing(can.language.rounding == Rounding::lost, "the order of floating-point operations",
            "this driver re-associates sums, so the window begins with the bias preset robust");
    const std::size_t block = can.storage_bytes;
    constexpr std::size_t WHOLE_PICTURE = 120'000'000;  // bytes of the list that `sorted` needs
    missing(can.storage && block < WHOLE_PICTURE,
            fmt::format("shader buffers beyond {} MB", block / 1'000'000),
            "sorted draws large pictures in more bands, which takes longer");
    return info;
}

int most_texels_of_a_side() {
    return gl_number(GL_MAX_TEXTURE_SIZE);
}

int most_texture_layers() {
    return gl_number(GL_MAX_ARRAY_TEXTURE_LAYERS);
}

int most_color_targets() {
    return std::min(gl_number(GL_MAX_DRAW_BUFFERS), gl_number(GL_MAX_COLOR_ATTACHMENTS));
}

std::size_t most_bytes_of_storage() {
    GLint64 bytes = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    return static_cast<std::size_t>(bytes);
}

}  // namespace momentscope
