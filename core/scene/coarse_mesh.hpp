// coarse_mesh.hpp -- the same mesh with fewer triangles.
#pragma once
#include "core/scene/scene.hpp"

namespace momentscope {

/// Keeps about a quarter of the triangles of a mesh that has 2000 or more; returns a smaller mesh as it is.
/// Every vertex is one of the mesh, with its normal and texture coordinates. The surface moves by no more
/// than 1 % of the mesh's extent, so that loose rectangles, as billboards are, keep all of their triangles.
/// Garland and Heckbert 1997 (quadric error metrics), by meshoptimizer. Takes about a second for 10^6
/// triangles.
Mesh coarse_mesh(Mesh mesh);

}  // namespace momentscope
