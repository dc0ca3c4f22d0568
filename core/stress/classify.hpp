// classify.hpp -- classifies one query of a reconstruction by comparing it with the exact result at the same
// moment bias. stress and tune count these outcomes.
#pragma once
#include <vector>

#include "core/ray/view_ray.hpp"

namespace momentscope {

constexpr double FAILED_ERROR = 0.02;     // of T: five 8-bit steps at white, about what is visible
constexpr float CLAMP_TOLERANCE = 1e-4f;  // rounding alone takes sums this far beyond [0, 1]

/// The outcome of a query, from the worst to the best: NaN; a result outside [0, b0] before it is clamped; an
/// error of T by more than FAILED_ERROR; none of these.
enum class Outcome { no_number, outside, inaccurate, ok };

/// Classifies a query. fraction: A / b0 before it is clamped. t: the T of the clamped fraction. exact_t: the
/// exact T at the same alpha.
Outcome classify(float fraction, double t, double exact_t);

/// T of a fraction of b0. The fraction is clamped as in the shaders: NaN counts as 0.
double transmittance_of_fraction(float fraction, float b0);

/// At most 8 fragments of a ray, chosen evenly in submission order: indices into ViewRay::fragments.
std::vector<std::size_t> some_fragments(const ViewRay& ray);

/// Their depths.
std::vector<float> some_own_depths(const ViewRay& ray);

}  // namespace momentscope
