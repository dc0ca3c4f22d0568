#include "ui/model/comparison_map.hpp"

#include <algorithm>
#include <cmath>

#include "core/compare/false_color.hpp"

namespace momentscope::ui {

namespace {

unsigned char srgb_byte(float linear) {
    return static_cast<unsigned char>(std::lround(255 * srgb_from_linear(linear)));
}

constexpr std::size_t STEPS = 1U << 16;  // of linear values; neighbours differ by at most one byte

// Computing a power for each channel of a large picture would cause a visible delay.
const std::vector<unsigned char>& srgb_bytes() {
    static const std::vector<unsigned char> bytes = [] {
        std::vector<unsigned char> table;
        for (std::size_t i = 0; i <= STEPS; ++i)
            table.push_back(srgb_byte(static_cast<float>(i) / static_cast<float>(STEPS)));
        return table;
    }();
    return bytes;
}

}  // namespace

const FalseColors& false_colors() {
    static const FalseColors colors = [] {
        std::array<float, std::tuple_size_v<FalseColors>> ramp{};
        for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = static_cast<float>(i);
        const Image image = false_color(ramp, static_cast<int>(ramp.size()), 1, ramp.back());
        FalseColors result{};
        for (std::size_t i = 0; i < result.size(); ++i) {
            const glm::vec4& color = image.pixels[i];
            result[i] = {srgb_byte(color.r), srgb_byte(color.g), srgb_byte(color.b), 255};
        }
        return result;
    }();
    return colors;
}

std::vector<unsigned char> difference_bytes(const PicturePair& pair, float gain) {
    const std::vector<unsigned char>& bytes = srgb_bytes();
    std::vector<unsigned char> rgba;
    rgba.reserve(4 * pair.picture.pixels.size());
    for (std::size_t i = 0; i < pair.picture.pixels.size(); ++i) {
        const glm::vec4 difference = glm::abs(pair.picture.pixels[i] - pair.reference.pixels[i]);
        for (int c = 0; c < 3; ++c) {
            const float shown = std::clamp(gain * difference[c], 0.0f, 1.0f);
            rgba.push_back(bytes[static_cast<std::size_t>(std::lround(shown * static_cast<float>(STEPS)))]);
        }
        rgba.push_back(255);
    }
    return rgba;
}

std::vector<unsigned char> false_color_bytes(std::span<const float> map, float end) {
    const FalseColors& colors = false_colors();
    std::vector<unsigned char> rgba;
    rgba.reserve(4 * map.size());
    const auto last = static_cast<float>(colors.size() - 1);
    for (const float value : map) {
        const auto& color =
            colors[static_cast<std::size_t>(std::lround(last * std::clamp(value / end, 0.0f, 1.0f)))];
        rgba.insert(rgba.end(), color.begin(), color.end());
    }
    return rgba;
}

}  // namespace momentscope::ui
