#include "core/compare/false_color.hpp"

#include <algorithm>
#include <vector>

#include "core/image/picture_module.hpp"

namespace momentscope {

Image false_color(std::span<const float> values, int width, int height, float full_scale) {
    std::vector<float> shares(values.size());
    std::ranges::transform(values, shares.begin(), [&](float value) { return value / full_scale; });
    std::vector<float> srgb(3 * shares.size());  // for the screen
    picture_codec().magma(shares.data(), shares.size(), srgb.data());
    Image image(width, height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = glm::vec4(linear_from_srgb(srgb[3 * i]), linear_from_srgb(srgb[3 * i + 1]),
                                    linear_from_srgb(srgb[3 * i + 2]), 1);
    return image;
}

}  // namespace momentscope
