#include "core/gl/capabilities.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/gl/framebuffer.hpp"
#include "core/gl/gl_info.hpp"
#include "core/gl/rounding_check.hpp"
#include "core/support/error.hpp"

namespace momentscope {

namespace {

#ifdef __EMSCRIPTEN__
constexpr bool IN_BROWSER = true;
#else
constexpr bool IN_BROWSER = false;
#endif

Dialect dialect_of(const GlVersion& version) {
    if (version.embedded) return Dialect::essl_300;
    if (version.number() >= 45) return Dialect::glsl_450;
    return version.number() >= 41 ? Dialect::glsl_410 : Dialect::glsl_330;
}

void require_supported(const GlVersion& version) {
    constexpr int LEAST = 33, LEAST_EMBEDDED = 30;
    if (version.number() < (version.embedded ? LEAST_EMBEDDED : LEAST))
        throw Error(fmt::format(
            "This GL is {} {}.{}, but Momentscope needs OpenGL 3.3 or OpenGL ES 3.0; update the driver, or use "
            "--gl osmesa, which draws in software.",
            version.embedded ? "OpenGL ES" : "OpenGL", version.major, version.minor));
    if (!version.embedded) return;
    for (const char* extension : {"GL_EXT_color_buffer_float", "GL_EXT_float_blend"})
        if (!has_gl_extension(extension))
            throw Error(fmt::format(
                "This GL lacks {}, so it cannot sum floats in a picture; use another device or driver.",
                extension));
}

OrderedAccess ordered_access(bool storage) {
    if (storage && has_gl_extension("GL_ARB_fragment_shader_interlock")) return OrderedAccess::interlock;
    return has_gl_extension("GL_EXT_shader_framebuffer_fetch") ? OrderedAccess::framebuffer_fetch
                                                               : OrderedAccess::none;
}

}  // namespace

Dialect current_dialect() {
    return dialect_of(gl_version());
}

Capabilities capabilities() {
    const GlVersion version = gl_version();
    require_supported(version);
    Capabilities gl;
    gl.language = language_of(dialect_of(version));
    gl.storage = row_of(gl.language.dialect).has_storage;
    gl.ordered = ordered_access(gl.storage);
    gl.unorm16 = !version.embedded;
    gl.blending_per_target = !version.embedded && version.number() >= 40;
    gl.timer_queries = !version.embedded;
    gl.answers_at_once = !IN_BROWSER;
    gl.primitive_ids = !version.embedded;
    gl.color_targets = std::min(most_color_targets(), MOST_COLOR_TARGETS);
    gl.storage_bytes = gl.storage ? most_bytes_of_storage() : 0;
    gl.language.rounding = kept_rounding(gl.language.dialect);
    return gl;
}

}  // namespace momentscope
