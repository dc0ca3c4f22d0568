// uncertainty.frag -- sums, by additive blending, how much of a pixel's luminance the bounds of its fragments leave open
// (docs/less_error.md).
#include "passes/blocks.glsl"
#include "passes/shading.glsl"
#include "passes/transparent_fragment.glsl"
#include "technique"
#include "passes/stored_moments.glsl"

EARLY_TESTS

layout(location = 0) out float open_luminance;

const vec3 LUMINANCE = vec3(0.2126, 0.7152, 0.0722);  // of linear sRGB (Rec. 709)

void main()
{
    FragmentEstimate estimate = fragment_estimate();
    vec3 color = shaded(object.color_opacity.rgb);
    float between = transmittance_of(estimate.lower) - transmittance_of(estimate.upper);
    open_luminance = fragment_opacity() * abs(dot(LUMINANCE, color)) * between;
}
