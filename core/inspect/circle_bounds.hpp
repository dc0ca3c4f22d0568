// circle_bounds.hpp -- sharp bounds for trigonometric moments, by linear programming.
#pragma once
#include <optional>
#include <span>
#include <stop_token>

#include "core/inspect/sharp_bounds.hpp"

namespace momentscope {

/// The least and the greatest absorbance in front of each depth over all distributions on the depth range
/// with the ray's first `count` trigonometric moments; theta: the wrapping zone (Algorithm 1 of Peters and
/// Klein 2015). Solves a linear program for each depth and bound, in two threads. Masses may lie at 2049 even
/// depths, at the fragments (if more than 500: at the nearest even depths) and at the query depth. Masses at
/// other depths are not considered. Moments hold to 1e-9, which widens the bounds if they almost determine
/// the truth. nullopt when stopped, or if the solver finds no solution.
std::optional<SharpBounds> circle_bounds(const ViewRay& ray, int count, double theta,
                                         std::span<const float> depths, const std::stop_token& stop);

}  // namespace momentscope
