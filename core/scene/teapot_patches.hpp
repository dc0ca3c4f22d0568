// teapot_patches.hpp -- the Utah teapot as Martin Newell measured it in 1975: control points and patches.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>

namespace momentscope {

constexpr int TEAPOT_POINT_COUNT = 290;  // Newell listed 306, some of them twice; duplicates are left out
constexpr int TEAPOT_PATCH_COUNT = 32;

/// Control points in the coordinates of Newell: z is up, the base is z = 0, the radius of the body is 2, and
/// the spout points to +x. The height is the usual 3.15, which Blinn squashed for his screen.
extern const glm::dvec3 TEAPOT_POINTS[TEAPOT_POINT_COUNT];

/// Each patch is a 4 x 4 grid of indices into TEAPOT_POINTS, with entry 4 * row + column. In every patch
/// (derivative along columns) x (derivative along rows) points outwards. If one grid row of a patch is a
/// single point (lid and base, at the axis), it is row 0.
extern const std::uint16_t TEAPOT_PATCHES[TEAPOT_PATCH_COUNT][16];

}  // namespace momentscope
