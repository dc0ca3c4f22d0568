// billboards.hpp -- particles for smoke, fog and clouds: flat polygons that face the camera.
#pragma once
#include "core/ray/random_ray.hpp"
#include "core/scene/scene.hpp"

namespace momentscope {

/// The place, the size and the directions of a particle. Lighting uses `normal`, which may be that of the
/// cloud to which the particle belongs.
struct Billboard {
    glm::vec3 center = glm::vec3(0);
    float radius = 1.0f;
    glm::vec3 facing = glm::vec3(0, 0, 1);
    glm::vec3 normal = glm::vec3(0, 0, 1);
    float turn = 0.0f;  // around `facing`, in radians
};

/// Adds a regular polygon whose corners lie on the circle of the radius. An alpha map covers the circle.
void add_billboard(Mesh& mesh, const Billboard& billboard, int corners);

/// A random point, uniform in the ball of radius 1 around the origin.
glm::vec3 in_unit_ball(RandomNumbers& random);

/// The opacity of a puff of smoke: highest in the middle, uneven, 0 at the rim.
AlphaMap make_puff(std::uint32_t seed);

}  // namespace momentscope
