// circle_bounds.hpp -- sharp bounds for trigonometric moments, by linear programming.
#pragma once
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/ray/view_ray.hpp"

namespace momentscope {

/// One bound for each depth, in [0, b0].
enum class Bound { lower, upper };

/// The least (or greatest) absorbance in front of each depth over all distributions on the depth range with
/// the ray's first `count` trigonometric moments, theta the wrapping zone (Algorithm 1 of Peters and Klein
/// 2015, as a linear program per depth). Masses may lie at 2049 even depths, at the fragments (of more than
/// 500: at the even depths beside them) and at the query depth; what masses between them would add is
/// missing. Moments hold to 1e-9, which widens the bounds where they almost determine the truth. nullopt when
/// stopped, or where the solver finds no solution.
std::optional<std::vector<float>> circle_bounds(Bound bound, const ViewRay& ray, int count, double theta,
                                                std::span<const float> depths, const std::stop_token& stop);

}  // namespace momentscope
