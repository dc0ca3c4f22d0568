// stored_state.glsl -- reads the state of a pixel with a technique without moments, and computes the transmittance from it. The
// state is in STATE_TEXELS textures of four floats.
#include "passes/pixel_state_fragment.glsl"

layout(binding = 2) uniform sampler2D state_textures[STATE_TEXELS];
#ifdef STATE_SAMPLES
layout(binding = 3) uniform usampler2DArray sample_depths;
#endif

PixelState state_at(ivec2 texel)
{
    PixelState state = empty_state(pixel_state_settings());
    UNROLL
    for (int i = 0; i < STATE_TEXELS; ++i) state = with_texel(state, i, texelFetch(state_textures[i], texel, 0));
#ifdef STATE_SAMPLES
    for (int s = 0; s < SAMPLE_COUNT; ++s) state.f[1 + s] = uintBitsToFloat(texelFetch(sample_depths, ivec3(texel, s), 0).x);
#endif
    return state;
}

#ifdef LOW_RESOLUTION
#include "shared/low_resolution.glsl"

PixelState with_share(PixelState sum, float share, ivec2 texel)
{
    PixelState part = filterable(state_at(texel), pixel_state_settings());
    PixelState result = sum;
    for (int i = 0; i < MAX_STATE_FLOATS; ++i) result.f[i] = sum.f[i] + share * part.f[i];
    return result;
}

PixelState stored_state(ivec2 pixel)
{
    ivec2 low = textureSize(state_textures[0], 0);
    Between x = between_low(pixel.x, frame.picture.x, low.x);
    Between y = between_low(pixel.y, frame.picture.y, low.y);
    PixelState state = zero_state();
    state = with_share(state, (1.0 - x.share) * (1.0 - y.share), ivec2(x.first, y.first));
    state = with_share(state, x.share * (1.0 - y.share), ivec2(x.second, y.first));
    state = with_share(state, (1.0 - x.share) * y.share, ivec2(x.first, y.second));
    return with_share(state, x.share * y.share, ivec2(x.second, y.second));
}
#elif defined(SECOND_STATE)
PixelState stored_state(ivec2 pixel)
{
    return filterable(state_at(pixel), pixel_state_settings());
}
#else
PixelState stored_state(ivec2 pixel)
{
    return state_at(pixel);
}
#endif

#ifdef TRANSPARENT_FRAGMENT
/// The transmittance to the current fragment; 1 if the technique defines none.
float fragment_transmittance()
{
#ifdef WITHOUT_DEPTHS
    return 1.0;
#else
    return transmittance_at(stored_state(ivec2(gl_FragCoord.xy)), pixel_state_fragment(vec3(0.0)), pixel_state_settings());
#endif
}
#endif
