// color.frag -- second pass: sums colours times opacity times transmittance by additive blending (paper, Section 3.2). The alpha
// channel sums the weights, for renormalisation. With UNCERTAIN it also sums by how much each weight may be moved.
#include "passes/blocks.glsl"
#include "passes/shading.glsl"
#include "passes/transparent_fragment.glsl"
#include "technique"
#include "passes/stored_moments.glsl"

EARLY_TESTS

layout(location = 0) out vec4 weighted_color;
#ifdef UNCERTAIN
layout(location = 1) out vec4 uncertain_color;
#endif

void main()
{
    FragmentEstimate estimate = fragment_estimate();
    float opacity = fragment_opacity();
    vec3 color = shaded(object.color_opacity.rgb);
    PRECISE float transmittance = estimate.transmittance;
    float weight = opacity * transmittance;
    weighted_color = vec4(color * weight, weight);
#ifdef UNCERTAIN
    float spread = opacity * estimate.spread;
    uncertain_color = vec4(color * spread, spread);
#endif
}
