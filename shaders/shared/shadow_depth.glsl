// shadow_depth.glsl -- a plain shadow map. Its depths, in [-1, 1], are not filtered. Instead the results of depth comparisons are
// filtered: percentage-closer filtering (Reeves et al. 1987).
#define UNFILTERED
#include "shadow_texel.glsl"

/// By how much a texel must be in front to cast a shadow. A slanted surface covers many depths within one texel. Without slack it
/// would shadow itself.
const float DEPTH_SLACK = 0.01f;

FN ShadowTexel shadow_texel(float depth)
{
    return make_shadow_texel(depth, 0.0f, 0.0f, 0.0f);
}

FN float shadowed_fraction(IN(ShadowTexel) texel, float depth)
{
    return texel.f[0] < depth - DEPTH_SLACK ? 1.0f : 0.0f;
}
