// cast_ray.hpp -- casts rays through the triangles of a scene: the ground truth of shadows without a map.
#pragma once
#include "core/scene/scene.hpp"

namespace momentscope {

/// What lies between a point and the light.
struct CastLight {
    bool shadowed = false;     // by an opaque caster
    double transmittance = 1;  // of all transparent casters
};

/// Surfaces within this distance, in scene units, belong to the receiver itself.
constexpr float LIGHT_SLACK = 1e-2f;

/// Casts a ray from a point to the light and intersects it with every triangle. Surfaces closer to the point
/// than `slack` scene units do not count, because the point lies on one of them.
CastLight cast_light(const Scene& scene, const glm::vec3& from, const glm::vec3& to, float slack);

}  // namespace momentscope
