// builtin_scenes.hpp -- the scenes that need no file; scenes.cpp lists them.
#pragma once
#include "core/scene/scene.hpp"

namespace momentscope {

Scene build_planes();
Scene build_spheres();
Scene build_teapots();
Scene build_ties();
Scene build_cloud();

/// The direction from a camera's target to the camera.
glm::vec3 towards_camera(const Camera& camera);

/// Adds a mesh and returns its index for Object::mesh.
std::uint32_t add_mesh(Scene& scene, Mesh mesh);

/// An opaque square of the given side at height y, in pale grey.
void add_ground(Scene& scene, float side, float y);

/// Linear RGB of a colour that is written as in HTML, 0xRRGGBB.
glm::vec3 linear_color(std::uint32_t srgb);

}  // namespace momentscope
