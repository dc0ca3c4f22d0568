#include "core/shadow/shadow_filter.hpp"

#include <algorithm>
#include <cmath>

namespace momentscope {

namespace {

/// The weights along one axis, for the texels from `first` on.
struct Span {
    int first = 0;
    std::vector<float> weights;
};

Span span_of(float at, int map_size, const std::vector<float>& gaussian) {
    const int radius = static_cast<int>(gaussian.size() / 2);
    const float below = std::floor(at - 0.5f);
    const float fraction = at - 0.5f - below;
    const auto last = map_size - 1;
    const int base = static_cast<int>(below);
    Span span;
    span.first = std::clamp(base - radius, 0, last);
    const int end = std::clamp(base + 1 + radius, 0, last);
    span.weights.resize(static_cast<std::size_t>(end - span.first + 1));
    for (const int corner : {0, 1}) {
        const float share = corner == 0 ? 1 - fraction : fraction;
        const int middle = std::clamp(base + corner, 0, last);  // interpolation is clamped at the border
        for (int k = -radius; k <= radius; ++k) {
            const int texel = std::clamp(middle + k, 0, last);  // and so is the filter
            span.weights[static_cast<std::size_t>(texel - span.first)] +=
                share * gaussian[static_cast<std::size_t>(k + radius)];
        }
    }
    return span;
}

}  // namespace

std::vector<float> gaussian_weights(int radius) {
    std::vector<float> weights;
    const double deviation = std::max(0.5 * radius, 1e-3);
    double sum = 0;
    for (int k = -radius; k <= radius; ++k) {
        const double weight = std::exp(-0.5 * k * k / (deviation * deviation));
        weights.push_back(static_cast<float>(weight));
        sum += weight;
    }
    for (float& weight : weights) weight = static_cast<float>(static_cast<double>(weight) / sum);
    return weights;
}

ShadowFootprint shadow_footprint(const glm::vec2& texel, int map_size, int radius) {
    const std::vector<float> gaussian = gaussian_weights(radius);
    const Span across = span_of(texel.x, map_size, gaussian);
    const Span up = span_of(texel.y, map_size, gaussian);
    ShadowFootprint footprint;
    footprint.corner = {across.first, up.first};
    footprint.extent = {across.weights.size(), up.weights.size()};
    for (const float row : up.weights)
        for (const float column : across.weights) footprint.weights.push_back(row * column);
    return footprint;
}

}  // namespace momentscope
