// fragment_estimates.hpp -- what the moments of a pixel know of each of its fragments.
#pragma once
#include <vector>

#include "core/inspect/curve.hpp"

namespace momentscope {

/// What the second pass computes for each fragment of a ray, in the order of ViewRay::fragments. The
/// technique must have moments.
std::vector<FragmentEstimate> fragment_estimates(const ViewRay& ray, const Technique& technique,
                                                 const ResolvedParameters& parameters);

}  // namespace momentscope
