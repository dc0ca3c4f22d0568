// shadow_variance.glsl -- variance shadow maps (Donnelly and Lauritzen 2006): two moments of the depth, in [-1, 1].
#include "shadow_texel.glsl"

/// Of a texel's depths at least: a surface is never as flat as one of its texels. A hundredth of half the depth range, squared.
const float MIN_VARIANCE = 1.0e-4f;

FN ShadowTexel shadow_texel(float depth)
{
    PRECISE float square = depth * depth;
    return make_shadow_texel(depth, square, 0.0f, 0.0f);
}

/// One minus the greatest lit fraction that a mean and a variance allow (Cantelli's inequality): never too dark.
FN float shadowed_fraction(IN(ShadowTexel) texel, float depth)
{
    PRECISE float variance = max(texel.f[1] - texel.f[0] * texel.f[0], MIN_VARIANCE);
    PRECISE float behind = max(depth - texel.f[0], 0.0f);
    PRECISE float square = behind * behind;
    PRECISE float fraction = square / (variance + square);
    return fraction;
}
