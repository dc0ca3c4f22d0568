// moments.frag -- first pass: sums the moments of the absorbance in each pixel (paper, Section 3.1).
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
#include "passes/accumulation.glsl"

layout(early_fragment_tests) in;

void main()
{
    Basis basis = frame_basis();
    Moments moments = fragment_moments(fragment_depth(), fragment_absorbance(), basis);
#ifdef INTERLOCK
    beginInvocationInterlockARB();
#endif
    accumulate(moments);
#ifdef INTERLOCK
    endInvocationInterlockARB();
#endif
}
