// cast_ray.hpp -- rays through the scene's triangles: the ground truth of shadows that needs no map.
#pragma once
#include "core/scene/scene.hpp"

namespace momentscope {

/// What lies between a point and the light.
struct CastLight {
    bool shadowed = false;     // by an opaque caster
    double transmittance = 1;  // of all transparent ones
};

/// Scene units within which a surface is that of the receiver itself.
constexpr float LIGHT_SLACK = 1e-2f;

/// Every triangle is tried. Surfaces closer to the point than `slack` scene units do not count: it lies on
/// one of them.
CastLight cast_light(const Scene& scene, const glm::vec3& from, const glm::vec3& to, float slack);

}  // namespace momentscope
