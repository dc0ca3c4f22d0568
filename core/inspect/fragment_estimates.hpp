// fragment_estimates.hpp -- what the moments of a pixel know of each of its fragments.
#pragma once
#include <vector>

#include "core/inspect/curve.hpp"

namespace momentscope {

/// What the second pass computes for each fragment of a ray, in the order of ViewRay::fragments. The
/// technique must have moments.
std::vector<FragmentEstimate> fragment_estimates(const ViewRay& ray, const Technique& technique,
                                                 const ResolvedParameters& parameters);

/// How uncertain the moments leave the colour of a pixel, without the truth: the sum over all fragments of
/// opacity times luminance times the difference between the greatest and the least T that the bounds allow.
/// estimates: the result of fragment_estimates.
double color_uncertainty(const ViewRay& ray, const std::vector<FragmentEstimate>& estimates);

}  // namespace momentscope
