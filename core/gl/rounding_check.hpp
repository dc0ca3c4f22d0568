// rounding_check.hpp -- asks a driver without `precise` what it does with sums whose rounding errors matter.
#pragma once
#include "core/gl/dialect.hpp"

namespace momentscope {

/// Draws the rounding errors of sums and products of known numbers (shared/float_pair.glsl), and compares
/// them with exact arithmetic: precise or unguarded, as the dialect has it, if they are right; guarded if
/// they does so once it cannot foresee them, else lost. Needs a current context whose shaders are of this
/// dialect.
Rounding kept_rounding(Dialect dialect);

/// True if the errors are right with this rounding.
bool keeps_rounding_errors(ShaderLanguage language);

}  // namespace momentscope
