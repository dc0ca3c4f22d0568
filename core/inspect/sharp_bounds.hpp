// sharp_bounds.hpp -- the least and the greatest absorbance that moments alone leave possible, by linear
// programming: bounds for any basis, and the only sharp ones for trigonometric moments.
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
/// the exact moments of the ray: without bias, without rounding (Algorithm 1 of Peters and Klein 2015, as a
/// linear program per depth and bound). So the truth always lies between them. `depths` in [-1, 1].
/// Masses may lie at 2049 even depths, at the fragments (of more than 500: at the even depths beside them)
/// and at the query depth; what masses between them would add is missing. Moments hold to 1e-9, which widens
/// the bounds where moments almost determine the truth. Power and Chebyshev moments have the same bounds.
/// Where so few surfaces lie on the ray that moments determine them (Section 4.1), they are the bounds.
/// Empty vectors where there is nothing to bound: no fragments, or a technique without moments.
/// nullopt when stopped, or where the solver finds no solution.
std::optional<SharpBounds> sharp_bounds(const ViewRay& ray, const Technique& technique,
                                        const ResolvedParameters& parameters, std::span<const float> depths,
                                        std::stop_token stop = {});

}  // namespace momentscope
