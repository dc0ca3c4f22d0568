// color.frag -- second pass: sums colours times opacity times transmittance by additive blending (paper, Section 3.2). The alpha
// channel sums the weights, for renormalisation.
#include "passes/blocks.glsl"
#include "passes/shading.glsl"
#include "passes/transparent_fragment.glsl"
#include "technique"
#include "passes/stored_moments.glsl"

layout(early_fragment_tests) in;

layout(location = 0) out vec4 weighted_color;

void main()
{
    float weight = fragment_opacity() * fragment_transmittance();
    weighted_color = vec4(shaded(object.color_opacity.rgb) * weight, weight);
}
