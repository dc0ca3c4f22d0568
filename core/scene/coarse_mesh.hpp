// coarse_mesh.hpp -- simplifies a mesh to fewer triangles.
#pragma once
#include "core/scene/scene.hpp"

namespace momentscope {

/// Keeps about a quarter of the triangles of a mesh that has 2000 or more. Smaller meshes are returned
/// unchanged. All vertices are vertices of the original mesh, with their normals and texture coordinates. The
/// surface moves by no more than 1 % of the extent of the mesh, so loose rectangles such as billboards keep
/// all of their triangles. Method: Garland and Heckbert 1997 (quadric error metrics), by meshoptimizer. Takes
/// about a second for 10^6 triangles.
Mesh coarse_mesh(Mesh mesh);

}  // namespace momentscope
