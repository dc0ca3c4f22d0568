// pareto.hpp -- finds the points of the Pareto front.
#pragma once
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace momentscope {

/// The points that no other point dominates. A point dominates another if it is at most as great in both
/// coordinates and less in one. Returns indices in the order of growing x. Of equal points all are returned.
/// Points that are not finite are left out.
std::vector<std::size_t> pareto_front(std::span<const glm::dvec2> points);

}  // namespace momentscope
