// builtin_scenes.hpp -- the scenes that need no file; scenes.cpp lists them.
#pragma once
#include <filesystem>

#include "core/scene/scene.hpp"

namespace momentscope {

Scene build_planes();
Scene build_spheres();
Scene build_teapots();
Scene build_ties();
Scene build_cloud();
Scene build_foliage();
Scene build_ship();
Scene build_smoke();

/// Foliage whose leaves have the shape that a picture file gives them; without it a warning and whole
/// rectangles.
Scene build_foliage(const std::filesystem::path& leaf);

/// The direction from a camera's target to the camera.
glm::vec3 towards_camera(const Camera& camera);

/// Adds a mesh and returns its index for Object::mesh.
std::uint32_t add_mesh(Scene& scene, Mesh mesh);

/// The same for Object::alpha_map.
std::uint32_t add_alpha_map(Scene& scene, AlphaMap map);

/// An opaque square of the given side at height y, in pale grey or another linear colour.
void add_ground(Scene& scene, float side, float y);
void add_ground(Scene& scene, float side, float y, const glm::vec3& color);

/// Linear RGB of a colour that is written as in HTML, 0xRRGGBB.
glm::vec3 linear_color(std::uint32_t srgb);

}  // namespace momentscope
