// billboards.hpp -- particles: flat polygons that face the camera, of smoke, fog and clouds.
#pragma once
#include "core/ray/random_ray.hpp"
#include "core/scene/scene.hpp"

namespace momentscope {

/// Where a particle is, and how it is lit: the normal may be that of the cloud it belongs to.
struct Billboard {
    glm::vec3 center = glm::vec3(0);
    float radius = 1.0f;
    glm::vec3 facing = glm::vec3(0, 0, 1);
    glm::vec3 normal = glm::vec3(0, 0, 1);
    float turn = 0.0f;  // around `facing`, radians
};

/// Adds a regular polygon with that many corners on the circle of the radius; a map covers the circle.
void add_billboard(Mesh& mesh, const Billboard& billboard, int corners);

/// Uniform in the ball of radius 1 around the origin.
glm::vec3 in_unit_ball(RandomNumbers& random);

/// The opacity of a puff of smoke: densest in the middle, uneven, nothing at the rim.
AlphaMap make_puff(std::uint32_t seed);

}  // namespace momentscope
