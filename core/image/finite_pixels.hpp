// finite_pixels.hpp -- finds colours that are infinite or NaN, for which no metric is defined.
#pragma once
#include <string>

#include "core/image/image.hpp"

namespace momentscope {

/// A text such as "12 of the 5184 pixels of NAME are infinite or NaN, the first at 3,4", counted from the
/// upper left corner. Empty if all colours are finite; alpha does not count.
std::string non_finite_text(const Image& image, const std::string& name);

}  // namespace momentscope
