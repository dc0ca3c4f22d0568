// moments.frag -- first pass: sums the moments of the absorbance in each pixel (paper, Section 3.1). With KNOWN_ENDS it also stores
// the ends of the ray or, with OWN_INTERVAL, reads them.
#include "passes/blocks.glsl"
#include "passes/shading.glsl"
#include "passes/transparent_fragment.glsl"
#include "technique"
#include "passes/frame_basis.glsl"
#include "shared/storage.glsl"
#include "passes/pixel_ends.glsl"
#include "passes/accumulation.glsl"

EARLY_TESTS

void main()
{
    Basis basis = frame_basis();
#ifdef OWN_INTERVAL
    float depth = moment_depth(fragment_depth(), stored_ends(ivec2(gl_FragCoord.xy)));
#else   // the ends of the pixel are not complete yet
    float depth = fragment_depth();
#endif
    Moments moments = fragment_moments(depth, fragment_absorbance(), basis);
    Ends ends = fragment_ends(fragment_depth(), fragment_absorbance());
#ifdef INTERLOCK
    beginInvocationInterlockARB();
#endif
    accumulate(moments);
    accumulate_ends(ends);
#ifdef INTERLOCK
    endInvocationInterlockARB();
#endif
}
