// failures.frag -- counts in each pixel, by additive blending, the fragments whose reconstruction failed and those whose sum was
// clamped.
#include "passes/blocks.glsl"
#include "passes/shading.glsl"
#include "passes/transparent_fragment.glsl"
#include "technique"
#include "passes/stored_moments.glsl"

EARLY_TESTS

layout(location = 0) out vec2 failed_clamped;

/// Rounding alone takes sums this far beyond [0, 1] (docs/tolerances.md).
const float CLAMP_TOLERANCE = 1.0e-4;

void main()
{
    Moments moments = stored_moments(ivec2(gl_FragCoord.xy));
    failed_clamped = vec2(0.0);
    if (is_empty(moments)) return;
    QueryMasses masses = fragment_masses(moments, stored_ends(ivec2(gl_FragCoord.xy)));
    float fraction = masses.in_front + frame.parameters.x * masses.at_query;
    bool within = fraction >= -CLAMP_TOLERANCE && fraction <= 1.0 + CLAMP_TOLERANCE;
#ifdef TEXTBOOK_SOLVER
    bool failed = !within;
#else
    bool failed = factor_moments(biased_moments(moments, frame.parameters.y)).floored > 0 || isnan(fraction);
#endif
    failed_clamped = vec2(failed ? 1.0 : 0.0, !failed && !within ? 1.0 : 0.0);
}
