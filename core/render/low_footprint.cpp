#include "core/render/low_footprint.hpp"

#include "core/support/glsl.hpp"

namespace momentscope {

namespace glsl::low_resolution {
#include "shaders/shared/low_resolution.glsl"
}  // namespace glsl::low_resolution

namespace g = glsl::low_resolution;

glm::ivec2 low_size_of(glm::ivec2 size, int divisor) {
    return {g::low_extent_of(size.x, divisor), g::low_extent_of(size.y, divisor)};
}

LowFootprint::LowFootprint(glm::ivec2 size, glm::ivec2 low_size, glm::ivec2 corner, glm::ivec2 extent)
    : size_(size), low_size_(low_size) {
    const glm::ivec2 last = corner + extent - 1;
    corner_ = {g::between_low(corner.x, size.x, low_size.x).first,
               g::between_low(corner.y, size.y, low_size.y).first};
    end_ = {g::between_low(last.x, size.x, low_size.x).second + 1,
            g::between_low(last.y, size.y, low_size.y).second + 1};
}

std::vector<LowResolutionSource> LowFootprint::shares_of(
    glm::ivec2 pixel, const std::vector<std::vector<Fragment>>& of_pixel) const {
    const g::Between x = g::between_low(pixel.x, size_.x, low_size_.x);
    const g::Between y = g::between_low(pixel.y, size_.y, low_size_.y);
    const auto fragments_at = [&](int column, int row) -> const std::vector<Fragment>& {
        const glm::ivec2 at = glm::ivec2(column, row) - corner_;
        return of_pixel[static_cast<std::size_t>(at.y * extent().x + at.x)];
    };
    return {{(1 - x.share) * (1 - y.share), fragments_at(x.first, y.first)},
            {x.share * (1 - y.share), fragments_at(x.second, y.first)},
            {(1 - x.share) * y.share, fragments_at(x.first, y.second)},
            {x.share * y.share, fragments_at(x.second, y.second)}};
}

}  // namespace momentscope
