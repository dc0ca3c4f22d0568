// pareto.hpp -- which of many compromises are worth making.
#pragma once
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace momentscope {

/// The points that no other one dominates: is at most as great in both coordinates and less in one. Indices
/// by growing x; of equal points all. Points that are not finite are never among them.
std::vector<std::size_t> pareto_front(std::span<const glm::dvec2> points);

}  // namespace momentscope
