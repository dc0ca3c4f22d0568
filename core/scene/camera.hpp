// camera.hpp -- matrices of an orbit camera, and the depth range of what it sees.
#pragma once
#include <glm/glm.hpp>

#include "core/ray/view_ray.hpp"
#include "core/scene/scene.hpp"

namespace momentscope {

constexpr float NEAR_PLANE = 0.05f;  // scene units; built-in scenes are 1 to 50 units large
constexpr float FAR_PLANE = 1000.0f;

/// The unit vector to what stands there: azimuth about the y axis from z, elevation above the xz plane, in
/// radians.
glm::vec3 orbit_direction(float azimuth, float elevation);

glm::mat4 view_matrix(const Camera& camera);  // world to eye, which looks along -z

/// aspect = width / height. The field of view holds for 16:9 and wider; narrower pictures see as much from
/// left to right as a 16:9 one, and more above and below.
glm::mat4 projection_matrix(const Camera& camera, float aspect);

/// The pixel that shows what Scene::picked shows in a 16:9 picture.
glm::ivec2 picked_pixel(const Scene& scene, glm::ivec2 size);

/// The logarithmic warp of Section 3.3 for a bounding sphere: its view depths, cut at the near plane. Never
/// empty.
DepthWarp depth_warp(const Camera& camera, const Sphere& bounds);

}  // namespace momentscope
