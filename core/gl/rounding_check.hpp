// rounding_check.hpp -- finds out whether a driver re-associates sums whose rounding errors matter.
#pragma once
#include "core/gl/dialect.hpp"

namespace momentscope {

/// How this driver must be kept from re-associating. precise or unguarded, as the dialect has it, if the
/// rounding errors are right then; else guarded if they are right with guards; else lost. Needs a current
/// context whose shaders may be of this dialect.
Rounding kept_rounding(Dialect dialect);

/// Draws the rounding errors of sums and products of known numbers (shared/float_pair.glsl), and sums and
/// products with constants. True if the errors are those of exact arithmetic and every operation is rounded
/// by itself.
bool keeps_rounding_errors(ShaderLanguage language);

}  // namespace momentscope
