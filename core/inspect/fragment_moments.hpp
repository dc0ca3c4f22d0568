// fragment_moments.hpp -- what each fragment of a ray adds to the moments.
#pragma once
#include <string>
#include <vector>

#include "core/inspect/curve.hpp"

namespace momentscope {

/// The moments a_l f_j(z_l) of each fragment, in submission order, by the source of the first pass. Their
/// sums are the moments of the ray, except for rounding. Empty for techniques without moments.
std::vector<MomentVector> fragment_moments(const ViewRay& ray, const Curve& curve);

/// The moments of the whole ray, as they are read from what the pixel stores.
MomentVector ray_moments(const Curve& curve);

/// The names of the functions f_j, such as "z²", "T2" or "cos 2φ", one for each stored number besides b0.
std::vector<std::string> moment_names(const Technique& technique);

}  // namespace momentscope
