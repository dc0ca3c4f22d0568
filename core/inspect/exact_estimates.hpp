// exact_estimates.hpp -- what a technique would know of fragments, and the curve that it would draw, in exact
// arithmetic (docs/less_error.md). It shares no code with shaders/.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "core/inspect/exact.hpp"

namespace momentscope {

/// What is known of one fragment.
struct ExactEstimate {
    double lower = 0, upper = 0;  // bounds of the absorbance in front
    double transmittance = 1;
    double spread = 0;
};

/// The estimates for some fragments of a ray, from an exact function of the scene's depths. places: indices
/// into ViewRay::fragments. If `exact` is nullopt, the moments determine the distribution, and only fragments
/// at the same depth are uncertain.
std::vector<ExactEstimate> exact_estimates(const std::optional<ExactFunction>& exact, const ViewRay& ray,
                                           const ResolvedParameters& parameters,
                                           std::span<const std::size_t> places);

/// The same for all fragments, in their order.
std::vector<ExactEstimate> exact_estimates(const std::optional<ExactFunction>& exact, const ViewRay& ray,
                                           const ResolvedParameters& parameters);

/// The exact curve by the estimate of the parameters at `depths` in [-1, 1], for queries that do not belong
/// to a fragment. With the published estimate this is exact_absorbance.
std::vector<double> exact_curve(const std::optional<ExactFunction>& exact, const ViewRay& ray,
                                const ResolvedParameters& parameters, std::span<const float> depths);

/// The unbiased exact curve: that of exact moments without bias, at `depths` in [-1, 1]. If the ray has so
/// few fragments that the moments determine the distribution (paper, Section 4.1), this is the truth, plus
/// beta times the mass at the depth itself. Empty for techniques without moments and for bases that
/// core/reference does not have.
std::vector<float> unbiased_absorbance(const ViewRay& ray, const Technique& technique,
                                       const ResolvedParameters& parameters, std::span<const float> depths);

}  // namespace momentscope
