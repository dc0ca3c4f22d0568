// quantisation_glsl.hpp -- the constants of a quantisation transform as GLSL declarations, which
// shaders/shared/unorm16_storage.glsl needs.
#pragma once
#include <string>

namespace momentscope {

/// Declarations of THETA_ODD, THETA_EVEN, their inverses and THETA_EVEN_OFFSET for 4, 6 or 8 power moments.
/// The floats are those of C++.
std::string quantisation_glsl(int moment_count);

}  // namespace momentscope
