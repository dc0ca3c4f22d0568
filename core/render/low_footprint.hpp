// low_footprint.hpp -- which pixels of low resolution the pixels of a picture read, and with what shares
// (shaders/shared/low_resolution.glsl).
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "core/ray/view_ray.hpp"

namespace momentscope {

/// divisor: 1, 2, 4 or 8.
glm::ivec2 low_size_of(glm::ivec2 size, int divisor);

/// Of a rectangle of the picture, counted from its lower left.
class LowFootprint {
public:
    LowFootprint(glm::ivec2 size, glm::ivec2 low_size, glm::ivec2 corner, glm::ivec2 extent);

    /// The rectangle of low resolution that is read.
    glm::ivec2 corner() const { return corner_; }
    glm::ivec2 extent() const { return end_ - corner_; }

    /// What a pixel reads, in the order in which the shader sums. of_pixel: row by row from the lower left of
    /// the rectangle.
    std::vector<LowResolutionSource> shares_of(glm::ivec2 pixel,
                                               const std::vector<std::vector<Fragment>>& of_pixel) const;

private:
    glm::ivec2 size_, low_size_, corner_, end_;
};

}  // namespace momentscope
