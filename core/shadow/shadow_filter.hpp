// shadow_filter.hpp -- which texels of a shadow map a receiver reads, and how much of each: a Gaussian over
// the map, then bilinear interpolation.
#pragma once
#include <glm/glm.hpp>
#include <vector>

namespace momentscope {

/// 2 radius + 1 weights that sum to 1, with the standard deviation radius / 2. radius >= 0.
std::vector<float> gaussian_weights(int radius);

/// A rectangle of texels with the weight of each, row by row from the lower left; they sum to 1. Texels
/// beyond the map are read at its border.
struct ShadowFootprint {
    glm::ivec2 corner{0};
    glm::ivec2 extent{0};
    std::vector<float> weights;
};

/// What is read at a place in texels of a map of map_size texels a side.
ShadowFootprint shadow_footprint(const glm::vec2& texel, int map_size, int radius);

}  // namespace momentscope
