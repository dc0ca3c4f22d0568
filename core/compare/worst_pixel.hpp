// worst_pixel.hpp -- finds the places where pictures differ most, one after another.
#pragma once
#include <optional>
#include <span>

#include "core/compare/difference.hpp"

namespace momentscope {

/// Pixels closer than this to a visited pixel belong to the same place.
constexpr int WORST_PIXEL_SPACING = 16;

/// The pixel with the greatest value of a map of this width, within the region, and at least
/// WORST_PIXEL_SPACING away from all visited pixels. If several have this value, the first. nullopt if only
/// zeros are left.
std::optional<glm::ivec2> next_worst_pixel(std::span<const float> map, int width, const PixelRegion& region,
                                           std::span<const glm::ivec2> visited);

}  // namespace momentscope
