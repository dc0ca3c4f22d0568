// stored_state.glsl -- what a pixel stores under a technique without moments: how passes read it and ask it. STATE_TEXELS
// textures of four floats.
#include "passes/method_fragment.glsl"

layout(binding = 2) uniform sampler2D state_textures[STATE_TEXELS];

PixelState stored_state(ivec2 pixel)
{
    PixelState state = empty_state(method_settings());
    for (int i = 0; i < STATE_TEXELS; ++i) state = with_texel(state, i, texelFetch(state_textures[i], pixel, 0));
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
