// shadow_onset.hpp -- over which depths the shadow of one caster begins.
#pragma once
#include "core/ray/view_ray.hpp"
#include "core/techniques/configuration.hpp"

namespace momentscope {

/// View depths from the light.
struct ShadowOnset {
    float caster = 0;  // where it is
    float low = 0;     // the shadow first exceeds a tenth of what it is in the end
    float high = 0;    // from here on it exceeds nine tenths
    float length() const { return high - low; }
};

/// The shadow of the fragments of one draw call within a light's ray: 1 - T / T without them, both by the
/// same technique. Of the truth it is a step. `sorted` is the truth.
ShadowOnset shadow_onset(const ViewRay& ray, std::uint32_t draw, const Configuration& configuration);

}  // namespace momentscope
