// shadow_hamburger.glsl -- shadow maps of four moments (Peters and Klein 2015). The result is the greatest lit fraction that the
// four moments allow, if depths may lie anywhere on the line. MOMENT_COUNT is 4; MOMENT_BITS is 32 or 16.
#include "power_moments.glsl"

#if MOMENT_BITS == 16
const float SHADOW_BIAS = 6.0e-5f;
#else
const float SHADOW_BIAS = 3.0e-7f;
#endif
const float SHADOW_PARAMETER = 0.0f;
#include "shadow_moments.glsl"

FN float shadowed_fraction(IN(ShadowTexel) texel, float depth)
{
    return share_in_front(region_at(region_moments(texel), depth));
}
