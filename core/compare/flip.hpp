// flip.hpp -- LDR-FLIP (Andersson et al. 2020): how different two pictures look when one flips between them.
#pragma once
#include <stop_token>
#include <vector>

#include "core/image/image.hpp"

namespace momentscope {

/// Pixels per degree of a 0.7 m wide display of 3840 pixels, seen from 0.7 m.
constexpr double PIXELS_PER_DEGREE = 67.0206432;

/// In [0, 1] per pixel, row by row. Linear RGB pictures of the same size, clamped to [0, 1].
/// Empty when it was stopped.
std::vector<float> flip_map(const Image& reference, const Image& test, const std::stop_token& stop = {});

}  // namespace momentscope
