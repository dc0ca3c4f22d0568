// stored_factor.glsl -- reads the factor of a pixel, which factor.frag computed.

layout(binding = 0) uniform sampler2D total_absorbance_texture;
layout(binding = 3) uniform sampler2D factor_1_texture;
layout(binding = 4) uniform sampler2D factor_2_texture;
layout(binding = 5) uniform sampler2D factor_3_texture;
layout(binding = 7) uniform sampler2D factor_4_texture;

/// If b0 is less than MIN_ABSORBANCE, everything else in the result is undefined.
PixelFactor stored_factor(ivec2 pixel)
{
    float b0 = texelFetch(total_absorbance_texture, pixel, 0).x;
    PixelFactorTexels texels;
    texels.texel[0] = texelFetch(factor_1_texture, pixel, 0);
    texels.texel[1] = PIXEL_FACTOR_FLOATS > 4 ? texelFetch(factor_2_texture, pixel, 0) : vec4(0.0);
    texels.texel[2] = PIXEL_FACTOR_FLOATS > 8 ? texelFetch(factor_3_texture, pixel, 0) : vec4(0.0);
    texels.texel[3] = PIXEL_FACTOR_FLOATS > 12 ? texelFetch(factor_4_texture, pixel, 0) : vec4(0.0);
    return unpacked_pixel(texels, b0);
}
