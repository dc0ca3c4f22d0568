// state.frag -- the first pass of techniques without moments: changes what a pixel stores by one fragment. With INTERLOCK or
// FRAMEBUFFER_FETCH in submission order, else by blending, and samples by atomic operations. SECOND_PASS: the second one, of
// those that have two.
#if defined(INTERLOCK)
#extension GL_ARB_fragment_shader_interlock : require
#elif defined(FRAMEBUFFER_FETCH)
#extension GL_EXT_shader_framebuffer_fetch : require
#endif
#include "passes/blocks.glsl"
#include "passes/shading.glsl"
#include "passes/transparent_fragment.glsl"
#include "technique"
#ifdef SECOND_PASS
#include "passes/stored_state.glsl"
#else
#include "passes/method_fragment.glsl"
#endif
#include "passes/state_targets.glsl"

#ifndef STATE_NEAREST
layout(early_fragment_tests) in;   // else the depth of what is discarded would be written
#endif

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
#elif defined(SECOND_PASS)
    write_state(second_fragment_state(stored_state(ivec2(gl_FragCoord.xy)), fragment, method_settings()));
#else
    PixelState state = fragment_state(fragment, method_settings());
#ifdef STATE_NEAREST
    if (state.f[3] == NO_DEPTH) discard;
#endif
    write_state(state);
#endif
}
