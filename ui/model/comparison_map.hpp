// comparison_map.hpp -- maps of differences as sRGB RGBA bytes.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "ui/model/comparison.hpp"

namespace momentscope::ui {

/// The absolute differences of the linear channels, times the gain.
std::vector<unsigned char> difference_bytes(const PicturePair& pair, float gain);

/// A map in the false colours of core/compare, from 0 to `end`. Greater values get the brightest colour.
std::vector<unsigned char> false_color_bytes(std::span<const float> map, float end);

using FalseColors = std::array<std::array<unsigned char, 4>, 256>;

/// The false colours, from 0 to the end.
const FalseColors& false_colors();

}  // namespace momentscope::ui
