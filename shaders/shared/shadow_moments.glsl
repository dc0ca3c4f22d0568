// shadow_moments.glsl -- texels of moment shadow maps: four real moments of any basis. The mathematics is that of transparency with
// b_0 = 1 and beta = 0. Include this file after the basis, with SHADOW_BIAS (alpha) and SHADOW_PARAMETER (the argument of
// make_basis) defined. With MOMENT_BITS 16, texels hold moments after the transform Theta_4. The transform is affine and b_0 is the
// same for all texels, so such texels can be filtered, too.
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

/// The biased moments of a filter region, with b_0 = 1.
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

/// The canonical representation of a filter region at a depth in [-1, 1].
FN Reconstruction region_at(IN(BiasedMoments) biased, float depth)
{
    return reconstruct(factor_moments(biased), make_basis(SHADOW_PARAMETER), depth);
}

/// The share of the filter region that lies in front of the depth, in [0, 1].
FN float share_in_front(IN(Reconstruction) at_depth)
{
    return number_in_unit_range(fraction_in_front(at_depth, 0.0f));
}
