#include "core/image/finite_pixels.hpp"

#include <fmt/format.h>

#include <cmath>

namespace momentscope {

std::string non_finite_text(const Image& image, const std::string& name) {
    std::size_t count = 0, first = 0;
    for (std::size_t i = image.pixels.size(); i-- > 0;) {
        const glm::vec4& pixel = image.pixels[i];
        if (std::isfinite(pixel.r) && std::isfinite(pixel.g) && std::isfinite(pixel.b)) continue;
        ++count;
        first = i;
    }
    if (count == 0) return "";
    const auto width = static_cast<std::size_t>(image.width);
    return fmt::format("{} of the {} pixels of {} are infinite or NaN, the first at {},{}", count,
                       image.pixels.size(), name, first % width, first / width);
}

}  // namespace momentscope
