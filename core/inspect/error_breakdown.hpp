// error_breakdown.hpp -- why a pixel is wrong: its error taken apart into causes, and the sentence that names
// the greatest.
#pragma once
#include <string>
#include <vector>

#include "core/ray/view_ray.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// One cause. Negative where it makes up for others, as renormalisation does.
struct Contribution {
    std::string cause;  // "the moment count"
    double share = 0;   // of the error, in linear RGB
};

/// The distance in linear RGB of a technique's colour from the true one, and what it is made of: the colours
/// of a chain of techniques from the truth to the one in question, each step of which adds one cause,
/// projected on the error. Shares therefore sum to the error.
struct ErrorBreakdown {
    double error = 0;
    std::vector<Contribution> contributions;  // in the order of the chain
    std::string sentence;
};

/// `behind`: linear RGB of what lies behind all fragments.
ErrorBreakdown pixel_error_breakdown(const ViewRay& ray, const Technique& technique,
                                     const ParameterValues& values, const glm::vec3& behind);

}  // namespace momentscope
