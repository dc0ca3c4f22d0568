// bounds.cpp -- how far the transparent things reach, for the depth warp.
#include "core/scene/scene.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

namespace momentscope {
namespace {

/// Calls visit(world position) for every vertex of every transparent object.
template <typename Visit>
void for_each_transparent_vertex(const Scene& scene, Visit visit) {
    for (const Object& object : scene.objects) {
        if (object.opaque()) continue;
        assert(object.mesh < scene.meshes.size());
        const glm::dmat4 model(object.model);
        for (const glm::vec3& position : scene.meshes[object.mesh].positions)
            visit(glm::dvec3(model * glm::dvec4(position, 1.0)));
    }
}

}  // namespace

// The sphere sits in the middle of the bounding box and reaches to the farthest vertex, which is often
// well inside the box's corners.
Sphere transparent_bounds(const Scene& scene) {
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high = -low;
    for_each_transparent_vertex(scene, [&](const glm::dvec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    });
    if (low.x > high.x) return {};  // nothing is transparent

    const glm::vec3 center(0.5 * (low + high));
    double radius = 0.0;
    for_each_transparent_vertex(
        scene, [&](const glm::dvec3& p) { radius = std::max(radius, glm::distance(p, glm::dvec3(center))); });
    // A few float ulps wider, so that a vertex transformed in float still lies inside.
    return {center, static_cast<float>(radius * (1.0 + 1e-6))};
}

}  // namespace momentscope
