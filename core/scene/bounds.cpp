// bounds.cpp -- spheres around transparent objects and around shadow casters, from which depth ranges follow.
#include "core/scene/scene.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

namespace momentscope {
namespace {

/// Calls visit(world position) for every vertex of every object for which `counts` is true.
template <typename Counts, typename Visit>
void for_each_vertex(const Scene& scene, const Counts& counts, Visit visit) {
    for (const Object& object : scene.objects) {
        if (!counts(object)) continue;
        assert(object.mesh < scene.meshes.size());
        const glm::dmat4 model(object.model);
        for (const glm::vec3& position : scene.meshes[object.mesh].positions)
            visit(glm::dvec3(model * glm::dvec4(position, 1.0)));
    }
}

// The sphere is centred in the bounding box and reaches to the farthest vertex. This vertex often lies well
// inside the corners of the box.
template <typename Counts>
Sphere bounds_of(const Scene& scene, const Counts& counts) {
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high = -low;
    for_each_vertex(scene, counts, [&](const glm::dvec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    });
    if (low.x > high.x) return {};  // no object counts

    const glm::vec3 center(0.5 * (low + high));
    double radius = 0.0;
    for_each_vertex(scene, counts, [&](const glm::dvec3& p) {
        radius = std::max(radius, glm::distance(p, glm::dvec3(center)));
    });
    // A few float ulps larger, so that a vertex that is transformed in float still lies inside.
    return {center, static_cast<float>(radius * (1.0 + 1e-6))};
}

}  // namespace

Sphere transparent_bounds(const Scene& scene) {
    return bounds_of(scene, [](const Object& object) { return !object.opaque(); });
}

Sphere caster_bounds(const Scene& scene) {
    return bounds_of(scene, [](const Object& object) { return object.casts_shadow; });
}

}  // namespace momentscope
