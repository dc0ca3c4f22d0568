// classify.hpp -- one query of a reconstruction against the exact result at the same moment bias: what stress
// and tune count.
#pragma once
#include <vector>

#include "core/ray/view_ray.hpp"

namespace momentscope {

constexpr double FAILED_ERROR = 0.02;     // of T: five 8-bit steps at white, about what is seen
constexpr float CLAMP_TOLERANCE = 1e-4f;  // rounding alone takes sums this far beyond [0, 1]

/// What happened to a query, the gravest first: no number; before it is clamped outside [0, b0]; a T that is
/// off by more than FAILED_ERROR; or nothing.
enum class Outcome { no_number, outside, inaccurate, ok };

/// fraction: A / b0 before it is clamped. t: from it, clamped. exact_t: at the same alpha.
Outcome classify(float fraction, double t, double exact_t);

/// T of a fraction of b0, clamped as the shaders do it: NaN counts as 0.
double transmittance_of_fraction(float fraction, float b0);

/// Depths of at most 8 of a ray's fragments, evenly chosen in submission order.
std::vector<float> some_own_depths(const ViewRay& ray);

}  // namespace momentscope
