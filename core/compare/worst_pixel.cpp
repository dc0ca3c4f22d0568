#include "core/compare/worst_pixel.hpp"

#include <algorithm>

namespace momentscope {

std::optional<glm::ivec2> next_worst_pixel(std::span<const float> map, int width, const PixelRegion& region,
                                           std::span<const glm::ivec2> visited) {
    const auto is_near = [&](glm::ivec2 pixel) {
        return std::ranges::any_of(visited, [&](glm::ivec2 other) {
            const glm::ivec2 way = pixel - other;
            return way.x * way.x + way.y * way.y < WORST_PIXEL_SPACING * WORST_PIXEL_SPACING;
        });
    };
    std::optional<glm::ivec2> worst;
    float most = 0;
    for (int y = region.y; y < region.y + region.height; ++y)
        for (int x = region.x; x < region.x + region.width; ++x) {
            const float value = map[static_cast<std::size_t>(y * width + x)];
            if (!(value > most) || is_near({x, y})) continue;
            most = value;
            worst = glm::ivec2(x, y);
        }
    return worst;
}

}  // namespace momentscope
