// builtin_scenes.hpp -- builds the scenes of builtin_scenes.def.
#pragma once
#include <filesystem>

#include "core/scene/scene.hpp"

namespace momentscope {

#define SCENE(id, description) Scene build_##id();
#include "core/scene/builtin_scenes.def"
#undef SCENE

/// Foliage with leaves of the shape in a picture file. If the file cannot be read, the scene gets a warning
/// and leaves are whole rectangles.
Scene build_foliage(const std::filesystem::path& leaf);

/// The unit vector from the target of a camera to the camera.
glm::vec3 towards_camera(const Camera& camera);

/// Adds a mesh and returns its index for Object::mesh.
std::uint32_t add_mesh(Scene& scene, Mesh mesh);

/// Adds an alpha map and returns its index for Object::alpha_map.
std::uint32_t add_alpha_map(Scene& scene, AlphaMap map);

/// Adds an opaque square of the given side at height y, in pale grey or in a linear colour.
void add_ground(Scene& scene, float side, float y);
void add_ground(Scene& scene, float side, float y, const glm::vec3& color);

/// The linear RGB of a colour that is written as in HTML, 0xRRGGBB.
glm::vec3 linear_color(std::uint32_t srgb);

}  // namespace momentscope
