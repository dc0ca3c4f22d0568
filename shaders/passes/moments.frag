// moments.frag -- first pass: sums the moments of the absorbance in each pixel (paper, Section 3.1). With KNOWN_ENDS it also stores
// the ends of the ray or, with OWN_INTERVAL, reads them.
#if defined(INTERLOCK)
#extension GL_ARB_fragment_shader_interlock : require
#elif defined(FRAMEBUFFER_FETCH)
#extension GL_EXT_shader_framebuffer_fetch : require
#endif
#include "passes/blocks.glsl"
#include "passes/shading.glsl"
#include "passes/transparent_fragment.glsl"
#include "technique"
#include "passes/frame_basis.glsl"
#include "shared/storage.glsl"
#include "passes/pixel_ends.glsl"
#include "passes/accumulation.glsl"

layout(early_fragment_tests) in;

void main()
{
    Basis basis = frame_basis();
    float depth = moment_depth(fragment_depth(), stored_ends(ivec2(gl_FragCoord.xy)));
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
