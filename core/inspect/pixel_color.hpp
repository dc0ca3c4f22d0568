// pixel_color.hpp -- the colour of a pixel: the true one, and the one that a technique computes.
#pragma once
#include <vector>

#include "core/inspect/pixel_history.hpp"

namespace momentscope {

struct PixelColors {
    glm::vec3 truth{0};      // linear RGB over the background
    glm::vec3 technique{0};  // with T of the technique, renormalised if chosen (paper, Equation 2)
};

/// What the composite makes of the sums of the second pass. weighted: the sum of T alpha_l (colour, 1).
/// uncertain: the sum of spread alpha_l (colour, 1). absorbance: b0.
glm::vec3 composited_color(glm::vec4 weighted, const glm::vec4& uncertain, float absorbance,
                           const ResolvedParameters& parameters, const glm::vec3& background);

/// The colours for a ray. rows: the history of the pixel with this technique, from front to back.
PixelColors pixel_colors(const ViewRay& ray, const std::vector<PixelHistoryRow>& rows,
                         const Technique& technique, const ResolvedParameters& parameters,
                         const glm::vec3& background);

}  // namespace momentscope
