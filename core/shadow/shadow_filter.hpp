// shadow_filter.hpp -- which texels of a shadow map a receiver reads, and with which weights: a Gaussian over
// the map, then bilinear interpolation.
#pragma once
#include <glm/glm.hpp>
#include <vector>

namespace momentscope {

/// The 2 radius + 1 weights of the Gaussian. They sum to 1. The standard deviation is radius / 2.
/// radius >= 0.
std::vector<float> gaussian_weights(int radius);

/// A rectangle of texels and the weight of each, row by row from the lower left. The weights sum to 1.
/// Outside of the map the texels at its border are read.
struct ShadowFootprint {
    glm::ivec2 corner{0};
    glm::ivec2 extent{0};
    std::vector<float> weights;
};

/// What is read at a place, given in texels, of a map with map_size texels along a side.
ShadowFootprint shadow_footprint(const glm::vec2& texel, int map_size, int radius);

}  // namespace momentscope
