// shadow_variance.glsl -- variance shadow maps (Donnelly and Lauritzen 2006). A texel stores two moments of the depth in [-1, 1].
#include "shadow_texel.glsl"

/// The least variance that is used. A surface covers more than one depth within a texel. The value is 1/100 of half the depth
/// range, squared.
const float MIN_VARIANCE = 1.0e-4f;

FN ShadowTexel shadow_texel(float depth)
{
    PRECISE float square = depth * depth;
    return make_shadow_texel(depth, square, 0.0f, 0.0f);
}

/// 1 minus the greatest lit fraction that the mean and the variance allow (Cantelli's inequality). Never too dark.
FN float shadowed_fraction(IN(ShadowTexel) texel, float depth)
{
    PRECISE float variance = max(texel.f[1] - texel.f[0] * texel.f[0], MIN_VARIANCE);
    PRECISE float behind = max(depth - texel.f[0], 0.0f);
    PRECISE float square = behind * behind;
    PRECISE float fraction = square / (variance + square);
    return fraction;
}
