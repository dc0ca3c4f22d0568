// sharp_bounds.hpp -- the least and the greatest absorbance in front of a depth that the moments alone allow.
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
    std::vector<float> lower;  // the least absorbance in front, without the depth itself
    std::vector<float> upper;  // the greatest absorbance in front, with the depth itself
};

/// The infimum and the supremum of A(z) among all distributions on the depth range that have the exact
/// moments of the ray, without bias and rounding. The truth always lies between them. `depths` are in [-1,
/// 1].
///
/// Power and Chebyshev moments have the same bounds. They are exact up to rounding and take microseconds
/// (canonical_masses.hpp). Trigonometric moments take a linear program for each depth (circle_bounds.hpp). If
/// the ray has so few surfaces that the moments determine the distribution (paper, Section 4.1), both bounds
/// are the truth.
///
/// The vectors are empty without fragments, or if the technique has no moments. nullopt if stopped, or if the
/// linear program finds no solution.
std::optional<SharpBounds> sharp_bounds(const ViewRay& ray, const Technique& technique,
                                        const ResolvedParameters& parameters, std::span<const float> depths,
                                        const std::stop_token& stop = {});

}  // namespace momentscope
