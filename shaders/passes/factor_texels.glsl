// factor_texels.glsl -- what the second pass needs of a factored pixel, as texels of four numbers: the factor; with SHARP_BOUNDS in
// the pixel's own interval, that of the inner measure; with KNOWN_ENDS, b_0 and the ends, so that one fetch fewer is needed.
// Include it after fragment_estimate.glsl and pixel_ends.glsl.

#if defined(SHARP_BOUNDS) && defined(OWN_INTERVAL)
#define WITH_INNER
#define BOTH_FACTORS_FLOATS (FACTOR_FLOATS + INNER_FLOATS)
#else
#define BOTH_FACTORS_FLOATS FACTOR_FLOATS
#endif
#ifdef KNOWN_ENDS
#define PIXEL_FACTOR_FLOATS (BOTH_FACTORS_FLOATS + 3)
#else
#define PIXEL_FACTOR_FLOATS BOTH_FACTORS_FLOATS
#endif
#define PIXEL_FACTOR_TEXELS ((PIXEL_FACTOR_FLOATS + 3) / 4)

/// The factors of the moments of a pixel, and the ends of its ray.
struct PixelFactor
{
    Factor whole;
#ifdef WITH_INNER
    Factor inner;
#endif
    Ends ends;
};

/// bias: alpha.
PixelFactor factored(Moments moments, Ends ends, float bias)
{
    BiasedMoments biased = biased_moments(moments, bias);
    PixelFactor pixel;
    pixel.whole = factor_moments(biased);
#ifdef WITH_INNER
    pixel.inner = factor_inner(biased);
#endif
    pixel.ends = ends;
    return pixel;
}

struct PixelFactorTexels { vec4 texel[5]; };

PixelFactorTexels packed_pixel(PixelFactor pixel)
{
    StoredFactor whole = packed_factor(pixel.whole);
    PixelFactorTexels result;
    UNROLL
    for (int i = 0; i < 20; ++i) result.texel[i / 4][i % 4] = i < FACTOR_FLOATS ? whole.x[min(i, FACTOR_FLOATS - 1)] : 0.0;
#ifdef WITH_INNER
    StoredInner inner = packed_inner(pixel.inner);
    UNROLL
    for (int i = 0; i < INNER_FLOATS; ++i) result.texel[(FACTOR_FLOATS + i) / 4][(FACTOR_FLOATS + i) % 4] = inner.x[i];
#endif
#ifdef KNOWN_ENDS
    result.texel[BOTH_FACTORS_FLOATS / 4][BOTH_FACTORS_FLOATS % 4] = pixel.whole.b0;
    result.texel[(BOTH_FACTORS_FLOATS + 1) / 4][(BOTH_FACTORS_FLOATS + 1) % 4] = pixel.ends.near;
    result.texel[(BOTH_FACTORS_FLOATS + 2) / 4][(BOTH_FACTORS_FLOATS + 2) % 4] = pixel.ends.far;
#endif
    return result;
}

/// b0: the total absorbance; not read with KNOWN_ENDS.
PixelFactor unpacked_pixel(PixelFactorTexels texels, float b0)
{
    StoredFactor whole;
    UNROLL
    for (int i = 0; i < FACTOR_FLOATS; ++i) whole.x[i] = texels.texel[i / 4][i % 4];
    PixelFactor pixel;
#ifdef WITH_INNER
    StoredInner inner;
    UNROLL
    for (int i = 0; i < INNER_FLOATS; ++i) inner.x[i] = texels.texel[(FACTOR_FLOATS + i) / 4][(FACTOR_FLOATS + i) % 4];
    pixel.inner = unpacked_inner(inner);
#endif
#ifdef KNOWN_ENDS
    pixel.whole = unpacked_factor(whole, texels.texel[BOTH_FACTORS_FLOATS / 4][BOTH_FACTORS_FLOATS % 4]);
    pixel.ends = make_ends(texels.texel[(BOTH_FACTORS_FLOATS + 1) / 4][(BOTH_FACTORS_FLOATS + 1) % 4],
                           texels.texel[(BOTH_FACTORS_FLOATS + 2) / 4][(BOTH_FACTORS_FLOATS + 2) % 4]);
#else
    pixel.whole = unpacked_factor(whole, b0);
    pixel.ends = make_ends(0.0, 0.0);
#endif
    return pixel;
}
