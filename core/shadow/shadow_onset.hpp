// shadow_onset.hpp -- the depths over which the shadow of one caster begins.
#pragma once
#include "core/ray/view_ray.hpp"
#include "core/techniques/configuration.hpp"

namespace momentscope {

/// View depths from the light.
struct ShadowOnset {
    float caster = 0;  // depth of the caster
    float low = 0;     // where the shadow first exceeds a tenth of its final value
    float high = 0;    // from here on the shadow exceeds nine tenths of it
    float length() const { return high - low; }
};

/// The onset of the shadow that the fragments of one draw call cast on a ray from the light. The shadow is
/// 1 - T / T', where T' is T without these fragments, both by the same technique. For the truth, which is the
/// technique `sorted`, it is a step.
ShadowOnset shadow_onset(const ViewRay& ray, std::uint32_t draw, const Configuration& configuration);

}  // namespace momentscope
