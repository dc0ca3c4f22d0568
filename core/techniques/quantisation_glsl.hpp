// quantisation_glsl.hpp -- the constants of a quantisation transform as GLSL, which
// shaders/shared/unorm16_storage.glsl asks for.
#pragma once
#include <string>

namespace momentscope {

/// Declarations of THETA_ODD, THETA_EVEN, their inverses and THETA_EVEN_OFFSET for 4, 6 or 8 power moments;
/// the same floats as in C++.
std::string quantisation_glsl(int moment_count);

}  // namespace momentscope
