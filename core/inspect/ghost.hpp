// ghost.hpp -- what a technique would show if arithmetic were exact and no bias were needed.
#pragma once
#include <span>
#include <vector>

#include "core/ray/view_ray.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// A(z, b, beta) at `depths` in [-1, 1] from exact moments without bias, in long double, by core/reference,
/// which shares no code with shaders/. Where so few fragments lie on the ray that their moments leave no
/// other distribution (Section 4.1), this is the truth, plus beta of the mass at the depth itself. Empty for
/// techniques without moments and for bases that core/reference does not have.
std::vector<float> unbiased_absorbance(const ViewRay& ray, const Technique& technique,
                                       const ResolvedParameters& parameters, std::span<const float> depths);

}  // namespace momentscope
