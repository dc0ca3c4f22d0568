// factor_texels.glsl -- what the second pass needs of a factored pixel, as up to four texels of four numbers: the factor and, with
// SHARP_BOUNDS in the pixel's own interval, that of the inner measure. Include it after fragment_estimate.glsl.

#if defined(SHARP_BOUNDS) && defined(OWN_INTERVAL)
#define WITH_INNER
#define PIXEL_FACTOR_FLOATS (FACTOR_FLOATS + INNER_FLOATS)
#else
#define PIXEL_FACTOR_FLOATS FACTOR_FLOATS
#endif

/// The factors of the moments of a pixel.
struct PixelFactor
{
    Factor whole;
#ifdef WITH_INNER
    Factor inner;
#endif
};

/// bias: alpha.
PixelFactor factored(Moments moments, float bias)
{
    BiasedMoments biased = biased_moments(moments, bias);
    PixelFactor pixel;
    pixel.whole = factor_moments(biased);
#ifdef WITH_INNER
    pixel.inner = factor_inner(biased);
#endif
    return pixel;
}

struct PixelFactorTexels { vec4 texel[4]; };

PixelFactorTexels packed_pixel(PixelFactor pixel)
{
    StoredFactor whole = packed_factor(pixel.whole);
    PixelFactorTexels result;
    UNROLL
    for (int i = 0; i < 16; ++i) result.texel[i / 4][i % 4] = i < FACTOR_FLOATS ? whole.x[min(i, FACTOR_FLOATS - 1)] : 0.0;
#ifdef WITH_INNER
    StoredInner inner = packed_inner(pixel.inner);
    UNROLL
    for (int i = FACTOR_FLOATS; i < PIXEL_FACTOR_FLOATS; ++i) result.texel[i / 4][i % 4] = inner.x[i - FACTOR_FLOATS];
#endif
    return result;
}

/// b0: the total absorbance, which is stored separately.
PixelFactor unpacked_pixel(PixelFactorTexels texels, float b0)
{
    StoredFactor whole;
    UNROLL
    for (int i = 0; i < FACTOR_FLOATS; ++i) whole.x[i] = texels.texel[i / 4][i % 4];
    PixelFactor pixel;
    pixel.whole = unpacked_factor(whole, b0);
#ifdef WITH_INNER
    StoredInner inner;
    UNROLL
    for (int i = FACTOR_FLOATS; i < PIXEL_FACTOR_FLOATS; ++i) inner.x[i - FACTOR_FLOATS] = texels.texel[i / 4][i % 4];
    pixel.inner = unpacked_inner(inner);
#endif
    return pixel;
}
