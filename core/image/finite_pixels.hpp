// finite_pixels.hpp -- pictures with colours that are infinite or NaN, which no metric can judge.
#pragma once
#include <string>

#include "core/image/image.hpp"

namespace momentscope {

/// "12 of the 5184 pixels of NAME are infinite or NaN, the first at 3,4", counted from the upper left
/// corner. Empty when all colours are finite; alpha does not count.
std::string non_finite_text(const Image& image, const std::string& name);

}  // namespace momentscope
