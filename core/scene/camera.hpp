// camera.hpp -- the matrices of an orbit camera, and the depth range that it sees.
#pragma once
#include <glm/glm.hpp>

#include "core/ray/view_ray.hpp"
#include "core/scene/scene.hpp"

namespace momentscope {

constexpr float NEAR_PLANE = 0.05f;  // scene units; transparent parts of built-in scenes are 5 to 37 large
constexpr float FAR_PLANE = 1000.0f;

/// The unit vector in the direction with these angles in radians: azimuth about the y axis from z, elevation
/// above the xz plane.
glm::vec3 orbit_direction(float azimuth, float elevation);

glm::mat4 view_matrix(const Camera& camera);  // world to eye; the eye looks along -z

/// aspect = width / height. For 16:9 and wider pictures the vertical field of view is that of the camera.
/// Narrower pictures show as much from left to right as a 16:9 picture, and more above and below.
glm::mat4 projection_matrix(const Camera& camera, float aspect);

/// The pixel that shows the same as Scene::picked does in a 16:9 picture.
glm::ivec2 picked_pixel(const Scene& scene, glm::ivec2 size);

/// The logarithmic warp (paper, Section 3.3) for a bounding sphere: its view depths, cut at the near plane.
/// The range is never empty.
DepthWarp depth_warp(const Camera& camera, const Sphere& bounds);

}  // namespace momentscope
