// stored_state.glsl -- what a pixel stores under a technique without moments: how passes name it, read it and ask it. STATE_TEXELS
// textures of four floats, from binding 2 on.
#include "passes/method_fragment.glsl"

layout(binding = 2) uniform sampler2D state_texture_0;
#if STATE_TEXELS > 1
layout(binding = 3) uniform sampler2D state_texture_1;
#endif
#if STATE_TEXELS > 2
layout(binding = 4) uniform sampler2D state_texture_2;
#endif
#if STATE_TEXELS > 3
layout(binding = 5) uniform sampler2D state_texture_3;
#endif
#if STATE_TEXELS > 4
layout(binding = 6) uniform sampler2D state_texture_4;
#endif
#if STATE_TEXELS > 5
layout(binding = 7) uniform sampler2D state_texture_5;
#endif
#if STATE_TEXELS > 6
layout(binding = 8) uniform sampler2D state_texture_6;
#endif
#if STATE_TEXELS > 7
layout(binding = 9) uniform sampler2D state_texture_7;
#endif

PixelState stored_state(ivec2 pixel)
{
    PixelState state = empty_state(method_settings());
    SET_TEXEL(state, 0, texelFetch(state_texture_0, pixel, 0));
#if STATE_TEXELS > 1
    SET_TEXEL(state, 1, texelFetch(state_texture_1, pixel, 0));
#endif
#if STATE_TEXELS > 2
    SET_TEXEL(state, 2, texelFetch(state_texture_2, pixel, 0));
#endif
#if STATE_TEXELS > 3
    SET_TEXEL(state, 3, texelFetch(state_texture_3, pixel, 0));
#endif
#if STATE_TEXELS > 4
    SET_TEXEL(state, 4, texelFetch(state_texture_4, pixel, 0));
#endif
#if STATE_TEXELS > 5
    SET_TEXEL(state, 5, texelFetch(state_texture_5, pixel, 0));
#endif
#if STATE_TEXELS > 6
    SET_TEXEL(state, 6, texelFetch(state_texture_6, pixel, 0));
#endif
#if STATE_TEXELS > 7
    SET_TEXEL(state, 7, texelFetch(state_texture_7, pixel, 0));
#endif
    return state;
}

#ifdef TRANSPARENT_FRAGMENT
/// What is seen of the fragment at hand.
float fragment_transmittance()
{
#ifdef WITHOUT_DEPTHS
    return 1.0;
#else
    return transmittance_at(stored_state(ivec2(gl_FragCoord.xy)), method_fragment(vec3(0.0)), method_settings());
#endif
}
#endif
