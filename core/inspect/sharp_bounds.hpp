// sharp_bounds.hpp -- the least and the greatest absorbance that moments alone leave possible.
#pragma once
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/ray/view_ray.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// Absorbances at `depth`, in [0, b0].
struct SharpBounds {
    std::vector<float> depth;
    std::vector<float> lower;  // what lies in front, the depth itself excluded, at least
    std::vector<float> upper;  // what lies in front, the depth itself included, at most
};

/// The infimum and the supremum of A(z) over all distributions of absorbance on the depth range that have
/// the exact moments of the ray: without bias, without rounding. So the truth always lies between them.
/// `depths` in [-1, 1]. Power and Chebyshev moments have the same bounds. They are exact up to rounding and
/// take microseconds (canonical_masses.hpp). Trigonometric moments take a linear program for each depth
/// (circle_bounds.hpp). If so few surfaces lie on the ray that moments determine it (Section 4.1), both
/// bounds are the truth. Empty vectors where there is nothing to bound: no fragments, or a technique without
/// moments. nullopt when stopped, or where the linear program finds no solution.
std::optional<SharpBounds> sharp_bounds(const ViewRay& ray, const Technique& technique,
                                        const ResolvedParameters& parameters, std::span<const float> depths,
                                        std::stop_token stop = {});

}  // namespace momentscope
