// gl_info.hpp -- what this machine's OpenGL is, and what it lacks.
#pragma once
#include <string>
#include <vector>

namespace momentscope {

struct MissingFeature {
    std::string feature;
    std::string consequence;  // what is not possible therefore
};

struct GlInfo {
    std::string renderer, version;
    bool software = false;  // rasterised by the CPU
    std::vector<MissingFeature> missing;
};

/// Of the current context.
GlInfo gl_info();

}  // namespace momentscope
