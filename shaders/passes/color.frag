// color.frag -- second pass: colours weighted by opacity and transmittance, summed by additive blending
// (Section 3.2). Alpha sums the weights, for the renormalisation.
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
