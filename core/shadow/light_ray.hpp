// light_ray.hpp -- the functions of depth between the light and a receiver. A filtered texel is a mixture of
// many rays. Since absorbances are summed, the mixture is a ray again: the absorbance of each fragment is
// multiplied by the weight of its texel.
#pragma once
#include <vector>

#include "core/ray/view_ray.hpp"
#include "core/shadow/light_camera.hpp"
#include "core/shadow/opaque_shadow.hpp"
#include "core/techniques/moment_kernel.hpp"

namespace momentscope {

/// The opaque depth of one texel of the filter region, and the weight of the texel.
struct OpaqueShare {
    float depth = 1;   // of the nearest surface, in [-1, 1]; 1 if there is none
    float weight = 0;  // in [0, 1]; the weights of a region sum to 1
};

/// One texel of the filter region and its transparent fragments.
struct LightTexel {
    float weight = 0;
    std::vector<Fragment> fragments;  // in submission order
};

/// All fragments and depths between the light and a receiver, and what the maps hold of them.
struct ShadowFilterSamples {
    ShadowMapPosition place;          // of the receiver
    float receiver_absorbance = 0;    // of the receiver itself, if it casts shadows, too
    std::vector<LightTexel> texels;   // the filter region; empty outside of the map
    std::vector<OpaqueShare> opaque;  // of the same texels
    DepthWarp warp;                   // linear
    float near_plane = 0, far_plane = 0;

    // What the maps hold after filtering and interpolation. The shading reads these numbers.
    std::vector<float> sums;  // of transparent casters, b_0 first; empty for a deep map
    ShadowTexel texel{};      // of opaque casters; unused if the map is not filtered
};

/// The mixture of all texels as one ray: the absorbance of each fragment is multiplied by the weight of its
/// texel.
ViewRay mixed_ray(const ShadowFilterSamples& bundle);

/// The depths of opaque casters as one ray. Its total absorbance is 1, and its A(z) is the share of the
/// filter region in front of z.
ViewRay opaque_ray(const ShadowFilterSamples& bundle);

/// T in front of a depth as a deep shadow map has it: the weighted mean of the transmittances of the texels.
double deep_transmittance(const ShadowFilterSamples& bundle, float depth);

/// The transmittance of the weighted mean of the absorbances of the texels. This is the best that moments can
/// know.
double mixed_transmittance(const ShadowFilterSamples& bundle, float depth);

/// The share of light that transparent casters let through to a receiver at this depth, as the shading
/// computes it from the map.
float light_transmittance(const ShadowFilterSamples& bundle, const Configuration& transparent, float depth);

/// The same for opaque casters: the share of the filter region in front.
float light_shadowed(const ShadowFilterSamples& bundle, const OpaqueShadow& opaque, float depth);

}  // namespace momentscope
