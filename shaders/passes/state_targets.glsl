// state_targets.glsl -- where state.frag writes, and with ordered access reads, what a pixel stores: STATE_TEXELS groups of four
// floats, as images (INTERLOCK) or colour attachments.

#ifdef INTERLOCK
layout(pixel_interlock_ordered) in;
layout(binding = 0, rgba32f) uniform coherent image2D state_images[STATE_TEXELS];
#elif defined(FRAMEBUFFER_FETCH)
layout(location = 0) inout vec4 state_texels[STATE_TEXELS];
#else
layout(location = 0) out vec4 state_texels[STATE_TEXELS];
#endif

#if defined(INTERLOCK) || defined(FRAMEBUFFER_FETCH)
PixelState read_state()
{
    PixelState state = empty_state(method_settings());
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
    for (int i = 0; i < STATE_TEXELS; ++i)
    {
        vec4 texel = vec4(state.f[4 * i], state.f[4 * i + 1], state.f[4 * i + 2], state.f[4 * i + 3]);
#ifdef INTERLOCK
        imageStore(state_images[i], ivec2(gl_FragCoord.xy), texel);
#else
        state_texels[i] = texel;
#endif
    }
}
