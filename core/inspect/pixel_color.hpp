// pixel_color.hpp -- what a pixel looks like: composited truly, and as a technique weighs its fragments.
#pragma once
#include <vector>

#include "core/inspect/pixel_history.hpp"

namespace momentscope {

struct PixelColors {
    glm::vec3 truth{0};      // linear RGB over the background
    glm::vec3 technique{0};  // the same with the technique's T, renormalised if asked for (Equation 2)
};

/// From a ray and its history with that technique, rows from front to back.
PixelColors pixel_colors(const ViewRay& ray, const std::vector<PixelHistoryRow>& rows,
                         const Technique& technique, const ResolvedParameters& parameters,
                         const glm::vec3& background);

}  // namespace momentscope
