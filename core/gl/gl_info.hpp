// gl_info.hpp -- the OpenGL of this machine, and the features that it lacks.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace momentscope {

struct MissingFeature {
    std::string feature;
    std::string consequence;  // what is therefore not possible
};

/// How the fragments of a pixel can read, change and write it one after another, in submission order.
enum class OrderedAccess { none, interlock, framebuffer_fetch };

/// The access in the current context: fragment shader interlock; if there is none, coherent framebuffer
/// fetch.
OrderedAccess ordered_access();

/// A sentence that says why techniques which need ordered access are not available.
constexpr const char* NO_ORDERED_ACCESS =
    "This GL has neither GL_ARB_fragment_shader_interlock nor GL_EXT_shader_framebuffer_fetch, so fragments cannot be added "
    "in order.";

struct GlInfo {
    std::string renderer, version;
    bool software = false;  // does the CPU rasterise?
    std::vector<MissingFeature> missing;
};

/// The information about the current context.
GlInfo gl_info();

/// Throws Error, with what to do, if the current context cannot draw pictures.
void require_supported_gl();

/// What the current context can hold.
int most_texels_of_a_side();
int most_texture_layers();
std::size_t most_bytes_of_storage();  // of one buffer that shaders may write

}  // namespace momentscope
