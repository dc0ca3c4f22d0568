// stored_factor.glsl -- reads the factor of a pixel, which factor.frag computed.

#ifndef KNOWN_ENDS
layout(binding = 0) uniform sampler2D total_absorbance_texture;
#endif
layout(binding = 3) uniform sampler2D factor_textures[PIXEL_FACTOR_TEXELS];

/// If b0 is less than MIN_ABSORBANCE, everything else in the result is undefined.
PixelFactor stored_factor(ivec2 pixel)
{
    PixelFactorTexels texels;
    UNROLL
    for (int i = 0; i < PIXEL_FACTOR_TEXELS; ++i) texels.texel[i] = texelFetch(factor_textures[i], pixel, 0);
#ifdef KNOWN_ENDS
    return unpacked_pixel(texels, 0.0);
#else
    return unpacked_pixel(texels, texelFetch(total_absorbance_texture, pixel, 0).x);
#endif
}
