// shadow_trigonometric.glsl -- shadow maps of two trigonometric moments, reconstructed by Algorithm 2 with b_0 = 1 and beta = 0.
// The trigonometric moment shadow maps of Peters and Klein (2015) need the sharp bound, which has no usable closed form. This file
// gives an estimate instead, which may be too dark. MOMENT_COUNT is 2; MOMENT_BITS is 32.
#include "trigonometric_moments.glsl"

const float SHADOW_BIAS = 4.0e-7f;
const float SHADOW_PARAMETER = 0.314159265f;   // theta: pi / 10
#include "shadow_moments.glsl"

FN float shadowed_fraction(IN(ShadowTexel) texel, float depth)
{
    return share_in_front(region_at(region_moments(texel), depth));
}
