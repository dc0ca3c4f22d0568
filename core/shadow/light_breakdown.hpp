// light_breakdown.hpp -- why a receiver is lit wrongly: leaking, wrong self-shadowing, filtering or bias.
#pragma once
#include <string>
#include <vector>

#include "core/inspect/error_breakdown.hpp"
#include "core/shadow/light_ray.hpp"

namespace momentscope {

/// Shares of the light that reach a receiver.
struct LightBreakdown {
    double true_transmittance =
        1;                     // of transparent casters, as a deep shadow map with the same filter has it
    double transmittance = 1;  // as the map's numbers give it
    double true_shadowed =
        0;  // share of the filter region behind opaque casters, by comparing each texel with pcf's slack
    double shadowed = 0;  // as the map's numbers give it

    /// What true_transmittance - transmittance is made of: positive where light is missing, negative where it
    /// leaks. They sum to the difference.
    std::vector<Contribution> contributions;
    std::string sentence;
};

LightBreakdown light_breakdown(const ShadowFilterSamples& bundle, const Configuration& transparent,
                               const OpaqueShadow& opaque);

}  // namespace momentscope
