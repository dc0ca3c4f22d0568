// false_color.hpp -- shows one number per pixel as a picture.
#pragma once
#include <span>

#include "core/image/image.hpp"

namespace momentscope {

/// The values in the colour map magma, from 0 to full_scale. Greater values have the brightest colour. Values
/// are given row by row.
Image false_color(std::span<const float> values, int width, int height, float full_scale);

}  // namespace momentscope
