// state_targets.glsl -- where state.frag writes, and with ordered access reads, what a pixel stores: STATE_TEXELS groups of four
// floats, as images (INTERLOCK) or colour attachments.

#ifdef INTERLOCK
layout(pixel_interlock_ordered) in;
layout(binding = 0, rgba32f) uniform coherent image2D state_image_0;
#if STATE_TEXELS > 1
layout(binding = 1, rgba32f) uniform coherent image2D state_image_1;
#endif
#if STATE_TEXELS > 2
layout(binding = 2, rgba32f) uniform coherent image2D state_image_2;
#endif
#if STATE_TEXELS > 3
layout(binding = 3, rgba32f) uniform coherent image2D state_image_3;
#endif
#if STATE_TEXELS > 4
layout(binding = 4, rgba32f) uniform coherent image2D state_image_4;
#endif
#if STATE_TEXELS > 5
layout(binding = 5, rgba32f) uniform coherent image2D state_image_5;
#endif
#if STATE_TEXELS > 6
layout(binding = 6, rgba32f) uniform coherent image2D state_image_6;
#endif
#if STATE_TEXELS > 7
layout(binding = 7, rgba32f) uniform coherent image2D state_image_7;
#endif
#else
#ifdef FRAMEBUFFER_FETCH
#define ATTACHMENT inout
#else
#define ATTACHMENT out
#endif
layout(location = 0) ATTACHMENT vec4 state_0;
#if STATE_TEXELS > 1
layout(location = 1) ATTACHMENT vec4 state_1;
#endif
#if STATE_TEXELS > 2
layout(location = 2) ATTACHMENT vec4 state_2;
#endif
#if STATE_TEXELS > 3
layout(location = 3) ATTACHMENT vec4 state_3;
#endif
#if STATE_TEXELS > 4
layout(location = 4) ATTACHMENT vec4 state_4;
#endif
#if STATE_TEXELS > 5
layout(location = 5) ATTACHMENT vec4 state_5;
#endif
#if STATE_TEXELS > 6
layout(location = 6) ATTACHMENT vec4 state_6;
#endif
#if STATE_TEXELS > 7
layout(location = 7) ATTACHMENT vec4 state_7;
#endif
#endif

#if defined(INTERLOCK) || defined(FRAMEBUFFER_FETCH)
PixelState read_state()
{
    PixelState state = empty_state(method_settings());
#ifdef INTERLOCK
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    SET_TEXEL(state, 0, imageLoad(state_image_0, pixel));
#if STATE_TEXELS > 1
    SET_TEXEL(state, 1, imageLoad(state_image_1, pixel));
#endif
#if STATE_TEXELS > 2
    SET_TEXEL(state, 2, imageLoad(state_image_2, pixel));
#endif
#if STATE_TEXELS > 3
    SET_TEXEL(state, 3, imageLoad(state_image_3, pixel));
#endif
#if STATE_TEXELS > 4
    SET_TEXEL(state, 4, imageLoad(state_image_4, pixel));
#endif
#if STATE_TEXELS > 5
    SET_TEXEL(state, 5, imageLoad(state_image_5, pixel));
#endif
#if STATE_TEXELS > 6
    SET_TEXEL(state, 6, imageLoad(state_image_6, pixel));
#endif
#if STATE_TEXELS > 7
    SET_TEXEL(state, 7, imageLoad(state_image_7, pixel));
#endif
#else
    SET_TEXEL(state, 0, state_0);
#if STATE_TEXELS > 1
    SET_TEXEL(state, 1, state_1);
#endif
#if STATE_TEXELS > 2
    SET_TEXEL(state, 2, state_2);
#endif
#if STATE_TEXELS > 3
    SET_TEXEL(state, 3, state_3);
#endif
#if STATE_TEXELS > 4
    SET_TEXEL(state, 4, state_4);
#endif
#if STATE_TEXELS > 5
    SET_TEXEL(state, 5, state_5);
#endif
#if STATE_TEXELS > 6
    SET_TEXEL(state, 6, state_6);
#endif
#if STATE_TEXELS > 7
    SET_TEXEL(state, 7, state_7);
#endif
#endif
    return state;
}
#endif

void write_state(PixelState state)
{
#ifdef INTERLOCK
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    imageStore(state_image_0, pixel, TEXEL(state, 0));
#if STATE_TEXELS > 1
    imageStore(state_image_1, pixel, TEXEL(state, 1));
#endif
#if STATE_TEXELS > 2
    imageStore(state_image_2, pixel, TEXEL(state, 2));
#endif
#if STATE_TEXELS > 3
    imageStore(state_image_3, pixel, TEXEL(state, 3));
#endif
#if STATE_TEXELS > 4
    imageStore(state_image_4, pixel, TEXEL(state, 4));
#endif
#if STATE_TEXELS > 5
    imageStore(state_image_5, pixel, TEXEL(state, 5));
#endif
#if STATE_TEXELS > 6
    imageStore(state_image_6, pixel, TEXEL(state, 6));
#endif
#if STATE_TEXELS > 7
    imageStore(state_image_7, pixel, TEXEL(state, 7));
#endif
#else
    state_0 = TEXEL(state, 0);
#if STATE_TEXELS > 1
    state_1 = TEXEL(state, 1);
#endif
#if STATE_TEXELS > 2
    state_2 = TEXEL(state, 2);
#endif
#if STATE_TEXELS > 3
    state_3 = TEXEL(state, 3);
#endif
#if STATE_TEXELS > 4
    state_4 = TEXEL(state, 4);
#endif
#if STATE_TEXELS > 5
    state_5 = TEXEL(state, 5);
#endif
#if STATE_TEXELS > 6
    state_6 = TEXEL(state, 6);
#endif
#if STATE_TEXELS > 7
    state_7 = TEXEL(state, 7);
#endif
#endif
}
