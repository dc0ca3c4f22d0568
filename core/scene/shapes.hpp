// shapes.hpp -- meshes made by formulas.
#pragma once
#include "core/scene/scene.hpp"

namespace momentscope {

/// A rectangle in the xy plane, centred at the origin and facing +z, with columns x rows cells.
Mesh make_rectangle(float width, float height, int columns, int rows);

/// A sphere of radius 1 around the origin, with `slices` around the y axis and `stacks` along it.
Mesh make_sphere(int slices, int stacks);

/// A curtain: a rectangle in the xy plane, centred at the origin. Its z is a wave with `folds` periods across
/// the width and the given amplitude. Normals are smooth.
Mesh make_curtain(float width, float height, int folds, float amplitude);

/// An open cylinder with `slices` sides around the y axis, which stands on y = 0. Normals are smooth.
Mesh make_column(float radius, float height, int slices);

/// The Utah teapot (Newell 1975) from its 32 bicubic Bezier patches, each tessellated into `divisions` x
/// `divisions` cells. y is up. The base stands on y = 0, the axis of the body is x = z = 0, the spout points
/// to +x, and the greatest radius of the body is 1. (2 units in the data of Newell are scaled to 1.)
Mesh make_teapot(int divisions);

}  // namespace momentscope
