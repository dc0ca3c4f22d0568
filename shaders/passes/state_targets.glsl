// state_targets.glsl -- the targets to which state.frag writes the state of a pixel, and from which it reads it with ordered
// access: STATE_TEXELS groups of four floats, as images (INTERLOCK) or colour attachments. A pass may write only WRITTEN_TEXELS of
// them, from FIRST_TEXEL on.
#ifndef FIRST_TEXEL
#define FIRST_TEXEL 0
#define WRITTEN_TEXELS STATE_TEXELS
#endif

#ifdef INTERLOCK
layout(pixel_interlock_ordered) in;
layout(binding = 0, rgba32f) uniform coherent image2D state_images[STATE_TEXELS];
#elif defined(FRAMEBUFFER_FETCH)
layout(location = 0) inout vec4 state_texels[STATE_TEXELS];
#else
layout(location = 0) out vec4 state_texels[WRITTEN_TEXELS];
#endif
#ifdef STATE_SAMPLES
layout(binding = 0, r32ui) uniform coherent uimage2DArray sample_images;
#endif

#if defined(INTERLOCK) || defined(FRAMEBUFFER_FETCH)
PixelState read_state()
{
    PixelState state = empty_state(pixel_state_settings());
    UNROLL
    for (int i = 0; i < STATE_TEXELS; ++i)
    {
#ifdef INTERLOCK
        vec4 texel = imageLoad(state_images[i], ivec2(gl_FragCoord.xy));
#else
        vec4 texel = state_texels[i];
#endif
        state = with_texel(state, i, texel);
    }
    return state;
}
#endif

void write_state(PixelState state)
{
    UNROLL
    for (int i = 0; i < WRITTEN_TEXELS; ++i)
    {
        int at = 4 * (FIRST_TEXEL + i);
        vec4 texel = vec4(state.f[at], state.f[at + 1], state.f[at + 2], state.f[at + 3]);
#ifdef INTERLOCK
        imageStore(state_images[i], ivec2(gl_FragCoord.xy), texel);
#else
        state_texels[i] = texel;
#endif
    }
#ifdef STATE_SAMPLES
    // Depths are not negative, so their bits are in the same order as the depths.
    for (int s = 0; s < SAMPLE_COUNT; ++s)
        imageAtomicMin(sample_images, ivec3(ivec2(gl_FragCoord.xy), s), floatBitsToUint(state.f[1 + s]));
#endif
}
