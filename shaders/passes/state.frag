// state.frag -- the first pass of techniques without moments: changes the state of a pixel by one fragment. With INTERLOCK or
// FRAMEBUFFER_FETCH this happens in submission order, otherwise by blending, and for samples by atomic operations. With SECOND_PASS
// it is the second pass that stores states, of techniques that have one.
#include "passes/blocks.glsl"
#include "passes/shading.glsl"
#include "passes/transparent_fragment.glsl"
#include "technique"
#ifdef SECOND_PASS
#include "passes/stored_state.glsl"
#else
#include "passes/pixel_state_fragment.glsl"
#endif
#include "passes/state_targets.glsl"

#ifdef STATE_NEAREST
layout(binding = 11) uniform sampler2D opaque_depth_texture;   // the depth test is used to keep the least f[3]
#else
EARLY_TESTS
#endif

void main()
{
    PixelStateFragment fragment = pixel_state_fragment(shaded(object.color_opacity.rgb));
#ifdef STATE_ORDERED
#ifdef INTERLOCK
    beginInvocationInterlockARB();
#endif
    write_state(with_fragment(read_state(), fragment, pixel_state_settings()));
#ifdef INTERLOCK
    endInvocationInterlockARB();
#endif
#elif defined(SECOND_PASS)
    write_state(second_fragment_state(stored_state(ivec2(gl_FragCoord.xy)), fragment, pixel_state_settings()));
#else
    PixelState state = fragment_state(fragment, pixel_state_settings());
#ifdef STATE_NEAREST
    if (state.f[3] == NO_DEPTH) discard;
    if (gl_FragCoord.z >= texelFetch(opaque_depth_texture, ivec2(gl_FragCoord.xy), 0).x) discard;
    gl_FragDepth = state.f[3];
#endif
    write_state(state);
#endif
}
