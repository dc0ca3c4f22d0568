// shadow_moments.glsl -- texels of four real moments, for moment shadow maps of any basis: the math of transparency with b_0 = 1 and
// beta = 0. Follows the basis; SHADOW_BIAS is its alpha and SHADOW_PARAMETER what its make_basis takes. With MOMENT_BITS 16 texels
// hold moments after the transform Theta_4. It is affine and b_0 is the same for all, so that such texels can be filtered.
#include "shadow_texel.glsl"
#include "storage.glsl"
#include "reconstruction.glsl"

FN ShadowTexel shadow_texel(float depth)
{
    Moments moments = fragment_moments(depth, 1.0f, make_basis(SHADOW_PARAMETER));
#if MOMENT_BITS == 16
    moments = transformed(moments, false);
    UNROLL
    for (int i = 0; i < MOMENT_FLOATS; ++i) moments.b[i] = moments.b[i] + transform_offset(i);
#endif
    return make_shadow_texel(moments.b[0], moments.b[1], moments.b[2], moments.b[3]);
}

/// Biased moments of a filter region, b_0 = 1.
FN BiasedMoments region_moments(IN(ShadowTexel) texel)
{
    Moments moments;
    moments.b0 = 1.0f;
    UNROLL
    for (int i = 0; i < MOMENT_FLOATS; ++i) moments.b[i] = texel.f[i];
#if MOMENT_BITS == 16
    UNROLL
    for (int i = 0; i < MOMENT_FLOATS; ++i) moments.b[i] = moments.b[i] - transform_offset(i);
    moments = transformed(moments, true);
#endif
    return biased_moments(moments, SHADOW_BIAS);
}

FN Reconstruction region_at(IN(BiasedMoments) biased, float depth)
{
    return reconstruct(factor_moments(biased), make_basis(SHADOW_PARAMETER), depth);
}

/// The share of the region in front of the depth.
FN float share_in_front(IN(Reconstruction) at_depth)
{
    return number_in_unit_range(fraction_in_front(at_depth, 0.0f));
}
