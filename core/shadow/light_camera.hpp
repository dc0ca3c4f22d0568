// light_camera.hpp -- the light as a camera that sees all casters.
#pragma once
#include <glm/glm.hpp>

#include "core/ray/view_ray.hpp"
#include "core/shadow/shadow_settings.hpp"

namespace momentscope {

struct LightCamera {
    glm::vec3 position{0};  // in the world
    glm::mat4 view{1};      // from world to light space, which looks along -z
    glm::mat4 projection{1};
    float near_plane = 0, far_plane = 0;
    DepthWarp warp;  // linear, over the sphere around the casters (paper, Section 6)
};

/// A point as seen from the light.
struct ShadowMapPosition {
    glm::vec2 texel{0};   // in texels of the map, from its lower left corner
    float depth = 0;      // in [-1, 1], over the sphere around the casters; clamped
    bool within = false;  // true if the map knows what shadows the point
};

/// The default distance of the light from the centre of a sphere around all casters.
float standard_light_distance(const Sphere& casters);

/// The frustum around a sphere. Throws Error if the light stands inside of the sphere or almost inside.
/// Without casters the frustum is arbitrary.
LightCamera light_camera(const ShadowSettings& settings, const Sphere& casters);

/// The place of a point of the world in the map, as shaders/passes/light.glsl computes it.
ShadowMapPosition light_place(const LightCamera& frame, int map_size, const glm::vec3& world);

}  // namespace momentscope
