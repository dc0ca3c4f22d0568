// moment_textures.glsl -- the textures that the first pass wrote.
#include "shared/storage.glsl"
#include "passes/moment_texels.glsl"

layout(binding = 0) uniform sampler2D total_absorbance_texture;
layout(binding = 1) uniform sampler2D moments_1_to_4_texture;
#if MOMENT_FLOATS > 4
layout(binding = 2) uniform sampler2D moments_5_to_8_texture;
#endif

Moments stored_moments(ivec2 pixel)
{
    float b0 = texelFetch(total_absorbance_texture, pixel, 0).x;
    vec4 first = texelFetch(moments_1_to_4_texture, pixel, 0);
#if MOMENT_FLOATS > 4
    vec4 second = texelFetch(moments_5_to_8_texture, pixel, 0);
#else
    vec4 second = vec4(0.0);
#endif
    return unpacked_moments(moments_of_texels(b0, first, second));
}
