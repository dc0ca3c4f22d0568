// shapes.hpp -- meshes made by formula.
#pragma once
#include "core/scene/scene.hpp"

namespace momentscope {

/// A rectangle in the xy plane, centred at the origin, facing +z; columns x rows cells.
Mesh make_rectangle(float width, float height, int columns, int rows);

/// A sphere of radius 1 around the origin, `slices` around the y axis and `stacks` along it.
Mesh make_sphere(int slices, int stacks);

/// A curtain: a rectangle in the xy plane, centred at the origin, whose z waves `folds` times across
/// the width with the given amplitude; smooth normals.
Mesh make_curtain(float width, float height, int folds, float amplitude);

/// An open cylinder of `slices` sides around the y axis, resting on y = 0; smooth normals.
Mesh make_column(float radius, float height, int slices);

/// The Utah teapot (Newell 1975) from its 32 bicubic Bezier patches, each tessellated into
/// `divisions` x `divisions` cells. y is up, the base rests on y = 0, the body's axis is x = z = 0, the
/// spout points to +x, and the body's greatest radius is 1 (2 units of Newell's data are scaled to 1).
Mesh make_teapot(int divisions);

}  // namespace momentscope
