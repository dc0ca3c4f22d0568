// fragment_estimates.hpp -- what the moments of a pixel know of each of its fragments.
#pragma once
#include <vector>

#include "core/inspect/curve.hpp"

namespace momentscope {

/// What the second pass computes for some fragments of a ray from what its pixel stores. places: indices into
/// ViewRay::fragments. The technique must have moments.
std::vector<FragmentEstimate> fragment_estimates(const ViewRay& ray, const MomentVector& stored,
                                                 const Technique& technique,
                                                 const ResolvedParameters& parameters,
                                                 std::span<const std::size_t> places);

/// The same for all fragments, in their order.
std::vector<FragmentEstimate> fragment_estimates(const ViewRay& ray, const Technique& technique,
                                                 const ResolvedParameters& parameters);

}  // namespace momentscope
