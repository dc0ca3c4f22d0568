// state_color.frag -- second pass of techniques whose state defines a transmittance at a depth: sums colours times opacity times
// transmittance by additive blending. The alpha channel sums the weights, for renormalisation.
#include "passes/blocks.glsl"
#include "passes/shading.glsl"
#include "passes/transparent_fragment.glsl"
#include "technique"
#include "passes/stored_state.glsl"

EARLY_TESTS

layout(location = 0) out vec4 weighted_color;
#ifdef EXACT_ABSORBANCE_SLOT
layout(location = 1) out vec4 exact_absorbance;   // that of this pixel alone, even if its state is a mixture
#endif

void main()
{
    float weight = fragment_opacity() * fragment_transmittance();
    weighted_color = vec4(shaded(object.color_opacity.rgb) * weight, weight);
#ifdef EXACT_ABSORBANCE_SLOT
    exact_absorbance = vec4(fragment_absorbance(), 0.0, 0.0, 0.0);
#endif
}
