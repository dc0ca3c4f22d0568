// gl_info.hpp -- what this machine's OpenGL is, and what it lacks.
#pragma once
#include <string>
#include <vector>

namespace momentscope {

struct MissingFeature {
    std::string feature;
    std::string consequence;  // what is not possible therefore
};

/// How fragments of a pixel can be read, changed and written one after another, in submission order.
enum class OrderedAccess { none, interlock, framebuffer_fetch };

/// Of the current context: fragment shader interlock, where there is none coherent framebuffer fetch.
OrderedAccess ordered_access();

/// Why techniques that need ordered access cannot run without it, as a sentence.
constexpr const char* NO_ORDERED_ACCESS =
    "This GL has neither GL_ARB_fragment_shader_interlock nor GL_EXT_shader_framebuffer_fetch, so fragments cannot be added "
    "in order.";

struct GlInfo {
    std::string renderer, version;
    bool software = false;  // rasterised by the CPU
    std::vector<MissingFeature> missing;
};

/// Of the current context.
GlInfo gl_info();

}  // namespace momentscope
