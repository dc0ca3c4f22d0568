// accumulation.glsl -- how the first pass adds the moments of a fragment to those of its pixel. One of these macros is defined:
//   BLENDING           additive blending; 32 bits only
//   FRAMEBUFFER_FETCH  reads and writes the colour attachments, in submission order
//   INTERLOCK          reads and writes images, in submission order (rasterizer ordered views)

#if MOMENT_FLOATS == 4
#define SECOND_MOMENTS 0
#else
#define SECOND_MOMENTS 1
#endif

// With KNOWN_ENDS, but not with OWN_INTERVAL, it also maximises the ends of the ray: by MAX blending, or like the moments.
#if defined(KNOWN_ENDS) && !defined(OWN_INTERVAL)
#define ACCUMULATES_ENDS
#endif

#ifdef INTERLOCK
layout(pixel_interlock_ordered) in;
#if MOMENT_BITS == 16
layout(binding = 0, r16f) uniform coherent image2D total_absorbance;
layout(binding = 1, rgba16) uniform coherent image2D moments_1_to_4;
#else
layout(binding = 0, r32f) uniform coherent image2D total_absorbance;
layout(binding = 1, rgba32f) uniform coherent image2D moments_1_to_4;
#endif
#if MOMENT_FLOATS == 6 && MOMENT_BITS == 16
layout(binding = 2, rg16) uniform coherent image2D moments_5_to_8;
#elif MOMENT_FLOATS == 6
layout(binding = 2, rg32f) uniform coherent image2D moments_5_to_8;
#elif MOMENT_FLOATS == 8 && MOMENT_BITS == 16
layout(binding = 2, rgba16) uniform coherent image2D moments_5_to_8;
#elif MOMENT_FLOATS == 8
layout(binding = 2, rgba32f) uniform coherent image2D moments_5_to_8;
#endif
#ifdef ACCUMULATES_ENDS
layout(binding = 3, rg16) uniform coherent image2D pixel_ends;
#endif
#else
#ifdef FRAMEBUFFER_FETCH
#define ATTACHMENT inout
#else
#define ATTACHMENT out
#endif
layout(location = 0) ATTACHMENT vec4 total_absorbance;
layout(location = 1) ATTACHMENT vec4 moments_1_to_4;
#if SECOND_MOMENTS
layout(location = 2) ATTACHMENT vec4 moments_5_to_8;
#endif
#if defined(ACCUMULATES_ENDS) && SECOND_MOMENTS
layout(location = 3) ATTACHMENT vec4 pixel_ends;
#elif defined(ACCUMULATES_ENDS)
layout(location = 2) ATTACHMENT vec4 pixel_ends;
#endif
#endif

#include "passes/moment_texels.glsl"

vec4 first_texel(Moments moments)
{
    return vec4(moments.b[0], moments.b[1], moments.b[2], moments.b[3]);
}

vec4 second_texel(Moments moments)
{
#if MOMENT_FLOATS == 6
    return vec4(moments.b[4], moments.b[5], 0.0, 0.0);
#elif MOMENT_FLOATS == 8
    return vec4(moments.b[4], moments.b[5], moments.b[6], moments.b[7]);
#else
    return vec4(0.0);
#endif
}

/// Adds the moments of the fragment to those of its pixel. With INTERLOCK, call it between beginInvocationInterlockARB and
/// endInvocationInterlockARB, which must stand in main.
void accumulate(Moments fragment)
{
#ifdef INTERLOCK
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float b0 = imageLoad(total_absorbance, pixel).x;
    vec4 first = imageLoad(moments_1_to_4, pixel);
#if SECOND_MOMENTS
    vec4 second = imageLoad(moments_5_to_8, pixel);
#else
    vec4 second = vec4(0.0);
#endif
    Moments sum = with_fragment(moments_of_texels(b0, first, second), fragment);
    imageStore(total_absorbance, pixel, vec4(sum.b0));
    imageStore(moments_1_to_4, pixel, first_texel(sum));
#if SECOND_MOMENTS
    imageStore(moments_5_to_8, pixel, second_texel(sum));
#endif
#else
#ifdef FRAMEBUFFER_FETCH
#if SECOND_MOMENTS
    vec4 second = moments_5_to_8;
#else
    vec4 second = vec4(0.0);
#endif
    Moments written = with_fragment(moments_of_texels(total_absorbance.x, moments_1_to_4, second), fragment);
#else
    Moments written = fragment;
#endif
    total_absorbance = vec4(written.b0, 0.0, 0.0, 0.0);
    moments_1_to_4 = first_texel(written);
#if SECOND_MOMENTS
    moments_5_to_8 = second_texel(written);
#endif
#endif
}

/// Maximises the ends of the ray. With INTERLOCK, call it in the same place as accumulate.
void accumulate_ends(Ends fragment)
{
#ifdef ACCUMULATES_ENDS
#ifdef INTERLOCK
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Ends stored = ends_of_texel(imageLoad(pixel_ends, pixel).xy);
    imageStore(pixel_ends, pixel, ends_texel(with_ends(stored, fragment)));
#elif defined(FRAMEBUFFER_FETCH)
    pixel_ends = ends_texel(with_ends(ends_of_texel(pixel_ends.xy), fragment));
#else
    pixel_ends = ends_texel(fragment);
#endif
#endif
}
