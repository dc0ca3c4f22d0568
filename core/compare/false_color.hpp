// false_color.hpp -- numbers per pixel as a picture.
#pragma once
#include <span>

#include "core/image/image.hpp"

namespace momentscope {

/// The colour map magma, from 0 to full_scale; what is beyond has the brightest colour. values row by row.
Image false_color(std::span<const float> values, int width, int height, float full_scale);

}  // namespace momentscope
