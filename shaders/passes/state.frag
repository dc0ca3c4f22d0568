// state.frag -- the first pass of techniques without moments: changes what a pixel stores by one fragment. With INTERLOCK or
// FRAMEBUFFER_FETCH in submission order, else by blending.
#if defined(INTERLOCK)
#extension GL_ARB_fragment_shader_interlock : require
#elif defined(FRAMEBUFFER_FETCH)
#extension GL_EXT_shader_framebuffer_fetch : require
#endif
#include "passes/blocks.glsl"
#include "passes/shading.glsl"
#include "passes/transparent_fragment.glsl"
#include "technique"
#include "passes/method_fragment.glsl"
#include "passes/state_targets.glsl"

layout(early_fragment_tests) in;

void main()
{
    MethodFragment fragment = method_fragment(shaded(object.color_opacity.rgb));
#ifdef STATE_ORDERED
#ifdef INTERLOCK
    beginInvocationInterlockARB();
#endif
    write_state(with_fragment(read_state(), fragment, method_settings()));
#ifdef INTERLOCK
    endInvocationInterlockARB();
#endif
#else
    write_state(fragment_state(fragment, method_settings()));
#endif
}
