// surfaces.hpp -- adds curved sheets and tubes to a mesh, for leaves, sails, ropes and bottles.
#pragma once
#include <functional>

#include "core/scene/scene.hpp"

namespace momentscope {

/// A point of a surface for u and v in [0, 1].
using Surface = std::function<glm::vec3(float u, float v)>;

/// Adds columns x rows cells of a surface. Normals are smooth and point to (along u) x (along v). Texture
/// coordinates are (u, v). The surface may shrink to a point at an edge, but nowhere else.
void add_surface(Mesh& mesh, int columns, int rows, const Surface& surface);

/// Adds an open tube from one point to another.
void add_tube(Mesh& mesh, const glm::vec3& from, const glm::vec3& to, float radius_from, float radius_to,
              int sides);

/// Adds a surface of revolution around the y axis through `foot`. profile: radius and height along it, from
/// the bottom up.
void add_revolved(Mesh& mesh, const glm::vec3& foot, const std::function<glm::vec2(float)>& profile,
                  int slices, int rows);

}  // namespace momentscope
