// light_ray.hpp -- the functions behind a receiver, seen from the light. A filtered texel mixes many rays: as
// absorbances are summed, the mixture is again a ray, of fragments that absorb as much less as their texel
// weighs.
#pragma once
#include <vector>

#include "core/ray/view_ray.hpp"
#include "core/shadow/light_camera.hpp"
#include "core/shadow/opaque_shadow.hpp"
#include "core/techniques/moment_kernel.hpp"

namespace momentscope {

/// An opaque caster of a texel of the filter region: what its depth weighs.
struct OpaqueShare {
    float depth = 1;   // of the nearest surface, [-1, 1]; 1 where there is none
    float weight = 0;  // [0, 1]; those of a region sum to 1
};

/// One texel of the filter region and its transparent fragments.
struct LightTexel {
    float weight = 0;
    std::vector<Fragment> fragments;  // in submission order
};

/// All that lights a receiver.
struct ShadowFilterSamples {
    ShadowMapPosition place;          // of the receiver
    std::vector<LightTexel> texels;   // the filter region; empty where the map knows nothing
    std::vector<OpaqueShare> opaque;  // the same texels
    DepthWarp warp;                   // linear
    float near_plane = 0, far_plane = 0;

    // What the map holds after filtering and interpolation, as the shading reads it.
    std::vector<float> sums;  // of transparent casters, b_0 first; empty for a deep map
    ShadowTexel texel{};      // of opaque casters; of an unfiltered one nothing
};

/// The mixture of all texels as one ray: the absorbance of each fragment times its texel's weight.
ViewRay mixed_ray(const ShadowFilterSamples& bundle);

/// Depths of opaque casters as one ray, whose total absorbance is 1 and whose A(z) is the share in front of
/// z.
ViewRay opaque_ray(const ShadowFilterSamples& bundle);

/// T in front of the receiver's depth: the mean over the texels of what each lets through, as a deep shadow
/// map has it.
double deep_transmittance(const ShadowFilterSamples& bundle, float depth);

/// exp of minus the mean of the texels' absorbances: what moments could know at best.
double mixed_transmittance(const ShadowFilterSamples& bundle, float depth);

/// What shading computes of the receiver: the share of light that transparent casters let through, from the
/// map's numbers.
float light_transmittance(const ShadowFilterSamples& bundle, const Configuration& transparent, float depth);

/// The same of opaque casters: the share of the region in front.
float light_shadowed(const ShadowFilterSamples& bundle, const OpaqueShadow& opaque, float depth);

}  // namespace momentscope
