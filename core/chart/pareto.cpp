#include "core/chart/pareto.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace momentscope {

std::vector<std::size_t> pareto_front(std::span<const glm::dvec2> points) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (std::isfinite(points[i].x) && std::isfinite(points[i].y)) order.push_back(i);
    std::ranges::sort(order, {}, [&](std::size_t i) { return std::tuple(points[i].x, points[i].y, i); });
    std::vector<std::size_t> front;
    for (const std::size_t i : order)
        if (front.empty() || points[i].y < points[front.back()].y || points[i] == points[front.back()])
            front.push_back(i);
    return front;
}

}  // namespace momentscope
