// low_footprint.hpp -- which low-resolution pixels the pixels of a picture read, and with which weights
// (shaders/shared/low_resolution.glsl).
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "core/ray/view_ray.hpp"

namespace momentscope {

/// The size of the moments for a picture of this size. divisor: 1, 2, 4 or 8.
glm::ivec2 low_size_of(glm::ivec2 size, int divisor);

/// The low-resolution pixels that a rectangle of the picture reads. Pixels count from the lower left.
class LowFootprint {
public:
    LowFootprint(glm::ivec2 size, glm::ivec2 low_size, glm::ivec2 corner, glm::ivec2 extent);

    /// The rectangle of low-resolution pixels that are read.
    glm::ivec2 corner() const { return corner_; }
    glm::ivec2 extent() const { return end_ - corner_; }

    /// The sources that a pixel reads, in the order in which the shader sums them. of_pixel: the fragments of
    /// the low-resolution pixels, row by row from the lower left of the rectangle.
    std::vector<LowResolutionSource> shares_of(glm::ivec2 pixel,
                                               const std::vector<std::vector<Fragment>>& of_pixel) const;

private:
    glm::ivec2 size_, low_size_, corner_, end_;
};

}  // namespace momentscope
