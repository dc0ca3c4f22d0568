// error_breakdown.hpp -- why a pixel is wrong: splits its error into causes, and names the greatest in a
// sentence.
#pragma once
#include <string>
#include <vector>

#include "core/ray/view_ray.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// One cause of the error. Its share is negative if it compensates for others, as renormalisation does.
struct Contribution {
    std::string cause;  // "the moment count"
    double share = 0;   // part of the error, in linear RGB
};

/// The error of a pixel: the distance in linear RGB between the colour of a technique and the true colour. A
/// chain of techniques leads from the truth to this technique, and each step of it adds one cause. The change
/// of colour in each step is projected on the direction of the error, so the shares sum to the error.
struct ErrorBreakdown {
    double error = 0;
    std::vector<Contribution> contributions;  // in the order of the steps
    std::string sentence;
};

/// Splits the error of the pixel with this view ray. behind: linear RGB of what lies behind all fragments.
ErrorBreakdown pixel_error_breakdown(const ViewRay& ray, const Technique& technique,
                                     const ParameterValues& values, const glm::vec3& behind);

}  // namespace momentscope
