// state_color.frag -- second pass of techniques whose state knows the transmittance at a depth: colours weighted by opacity and
// transmittance, summed by additive blending. Alpha sums the weights, for the renormalisation.
#include "passes/blocks.glsl"
#include "passes/shading.glsl"
#include "passes/transparent_fragment.glsl"
#include "technique"
#include "passes/stored_state.glsl"

layout(early_fragment_tests) in;

layout(location = 0) out vec4 weighted_color;
#ifdef EXACT_ABSORBANCE_SLOT
layout(location = 1) out vec4 exact_absorbance;   // of the pixel itself, whatever its state is mixed of
#endif

void main()
{
    float weight = fragment_opacity() * fragment_transmittance();
    weighted_color = vec4(shaded(object.color_opacity.rgb) * weight, weight);
#ifdef EXACT_ABSORBANCE_SLOT
    exact_absorbance = vec4(fragment_absorbance(), 0.0, 0.0, 0.0);
#endif
}
