// circle_bounds.hpp -- sharp bounds for trigonometric moments, by linear programming.
#pragma once
#include <optional>
#include <span>
#include <stop_token>

#include "core/inspect/sharp_bounds.hpp"

namespace momentscope {

/// The least and the greatest absorbance in front of each depth among all distributions on the depth range
/// that have the first `count` trigonometric moments of the ray (Algorithm 1 of Peters and Klein 2015).
/// theta: the angle of the wrapping zone. One linear program is solved for each depth and each bound, in two
/// threads. Masses may lie at 2049 evenly spaced depths, at the depths of the fragments (if there are more
/// than 500: at the nearest evenly spaced depths) and at the query depth, but nowhere else. Moments hold to
/// 1e-9, which widens the bounds if the moments almost determine the truth. nullopt if stopped, or if the
/// solver finds no solution.
std::optional<SharpBounds> circle_bounds(const ViewRay& ray, int count, double theta,
                                         std::span<const float> depths, const std::stop_token& stop);

}  // namespace momentscope
