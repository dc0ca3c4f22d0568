#include "core/compare/false_color.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace momentscope {

namespace {

// The colour map magma of matplotlib (public domain), at 17 even steps, as linear colours.
constexpr std::array<glm::vec3, 17> MAGMA = {{{0.000113f, 0.000036f, 0.001073f},
                                              {0.003066f, 0.002406f, 0.016033f},
                                              {0.012176f, 0.005476f, 0.062265f},
                                              {0.036874f, 0.005102f, 0.146314f},
                                              {0.081757f, 0.006177f, 0.200758f},
                                              {0.143411f, 0.011719f, 0.218382f},
                                              {0.226110f, 0.019191f, 0.221188f},
                                              {0.334672f, 0.027718f, 0.212689f},
                                              {0.471680f, 0.037966f, 0.191879f},
                                              {0.632894f, 0.053268f, 0.159870f},
                                              {0.795910f, 0.083327f, 0.124705f},
                                              {0.913454f, 0.146074f, 0.106311f},
                                              {0.970011f, 0.248466f, 0.120740f},
                                              {0.991142f, 0.384808f, 0.167590f},
                                              {0.992958f, 0.553563f, 0.247770f},
                                              {0.982888f, 0.756759f, 0.367372f},
                                              {0.970800f, 0.980633f, 0.521749f}}};

glm::vec3 magma(float share) {
    const float within = share > 0 ? std::min(share, 1.0f) : 0;  // 0 for a NaN
    const float steps = within * static_cast<float>(MAGMA.size() - 1);
    const float below = std::min(std::floor(steps), static_cast<float>(MAGMA.size() - 2));
    const auto i = static_cast<std::size_t>(below);
    return glm::mix(MAGMA[i], MAGMA[i + 1], steps - below);
}

}  // namespace

Image false_color(std::span<const float> values, int width, int height, float full_scale) {
    Image image(width, height);
    std::ranges::transform(values, image.pixels.begin(),
                           [&](float value) { return glm::vec4(magma(value / full_scale), 1); });
    return image;
}

}  // namespace momentscope
