// flip.hpp -- LDR-FLIP (Andersson et al. 2020): how different two pictures look if one switches between them.
#pragma once
#include <stop_token>
#include <vector>

#include "core/image/image.hpp"

namespace momentscope {

/// The pixels per degree of a 0.7 m wide display with 3840 pixels across, seen from 0.7 m.
constexpr double PIXELS_PER_DEGREE = 67.0206432;

/// The difference of each pixel, in [0, 1], row by row. Both pictures are linear RGB of the same size and are
/// clamped to [0, 1]. Empty if stopped.
std::vector<float> flip_map(const Image& reference, const Image& test, const std::stop_token& stop = {});

}  // namespace momentscope
