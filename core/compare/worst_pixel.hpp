// worst_pixel.hpp -- where pictures differ most, one place after another.
#pragma once
#include <optional>
#include <span>

#include "core/compare/difference.hpp"

namespace momentscope {

/// Pixels nearer to one that was visited belong to the same place.
constexpr int WORST_PIXEL_SPACING = 16;

/// The pixel of the greatest value of a map of that width, within the region, and at least the spacing away
/// from all that were visited; of several the first. nullopt when only zeros are left.
std::optional<glm::ivec2> next_worst_pixel(std::span<const float> map, int width, const PixelRegion& region,
                                           std::span<const glm::ivec2> visited);

}  // namespace momentscope
