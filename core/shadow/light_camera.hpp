// light_camera.hpp -- the light as a camera that sees all casters.
#pragma once
#include <glm/glm.hpp>

#include "core/ray/view_ray.hpp"
#include "core/shadow/shadow_settings.hpp"

namespace momentscope {

struct LightCamera {
    glm::vec3 position{0};  // in the world
    glm::mat4 view{1};      // world to the light's space, which looks along -z
    glm::mat4 projection{1};
    float near_plane = 0, far_plane = 0;
    DepthWarp warp;  // linear, over the sphere around the casters (Section 6)
};

/// A point as the light sees it.
struct ShadowMapPosition {
    glm::vec2 texel{0};   // in texels of the map, from its lower left corner
    float depth = 0;      // in [-1, 1] between the ends of the sphere around the casters; beyond it cut
    bool within = false;  // does the map know what shadows it?
};

/// How far the light stands from the centre of a sphere around all casters unless it is told otherwise.
float standard_light_distance(const Sphere& casters);

/// The frustum around a sphere. Throws Error when the light stands inside of it, or almost. Around nothing,
/// any frustum.
LightCamera light_camera(const ShadowSettings& settings, const Sphere& casters);

/// As shaders/passes/light.glsl computes it. world: a point in the world.
ShadowMapPosition light_place(const LightCamera& frame, int map_size, const glm::vec3& world);

}  // namespace momentscope
