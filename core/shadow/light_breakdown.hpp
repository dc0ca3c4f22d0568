// light_breakdown.hpp -- why a receiver is lit wrongly: light leaking, wrong self-shadowing, filtering or
// bias.
#pragma once
#include <string>
#include <vector>

#include "core/inspect/error_breakdown.hpp"
#include "core/shadow/light_ray.hpp"

namespace momentscope {

/// The light that reaches a receiver, and the error split into its causes.
struct LightBreakdown {
    double true_transmittance = 1;  // of transparent casters, by a deep shadow map with the same filter
    double transmittance = 1;       // as computed from the map
    double true_shadowed = 0;       // share of the filter region with opaque casters in front, by pcf
    double shadowed = 0;            // as computed from the map

    /// The causes of true_transmittance - transmittance. A share is positive if light is missing and negative
    /// if it leaks. The shares sum to the difference.
    std::vector<Contribution> contributions;
    std::string sentence;
};

LightBreakdown light_breakdown(const ShadowFilterSamples& bundle, const Configuration& transparent,
                               const OpaqueShadow& opaque);

}  // namespace momentscope
