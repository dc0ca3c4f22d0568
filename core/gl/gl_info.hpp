// gl_info.hpp -- the OpenGL of this machine, and the features that it lacks.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/gl/capabilities.hpp"

namespace momentscope {

struct MissingFeature {
    std::string feature;
    std::string consequence;  // what is therefore not possible
};

/// The version of the current context.
struct GlVersion {
    bool embedded = false;  // OpenGL ES
    int major = 0, minor = 0;
    int number() const { return 10 * major + minor; }
};
GlVersion gl_version();

bool has_gl_extension(std::string_view name);

struct GlInfo {
    std::string renderer, version;
    bool software = false;  // does the CPU rasterise?
    Capabilities can;
    std::vector<MissingFeature> missing;
};

/// The information about the current context, which has these capabilities.
GlInfo gl_info(const Capabilities& can);

/// What the current context can hold.
int most_texels_of_a_side();
int most_texture_layers();
int most_color_targets();
std::size_t most_bytes_of_storage();  // of one buffer that shaders may write

}  // namespace momentscope
