// factor.frag -- runs between the first and the second pass. It biases and factors the moments of a pixel once, for all of its
// fragments. Pixels without absorbance keep what they hold, because no pass reads it.
#include "passes/blocks.glsl"
#include "shared/portable_math.glsl"
#include "technique"
#include "passes/moment_textures.glsl"
#include "shared/reconstruction.glsl"
#include "passes/factor_texels.glsl"

layout(location = 0) out vec4 factor_1;
#if FACTOR_FLOATS > 4
layout(location = 1) out vec4 factor_2;
#endif
#if FACTOR_FLOATS > 8
layout(location = 2) out vec4 factor_3;
#endif

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (!(texelFetch(total_absorbance_texture, pixel, 0).x >= MIN_ABSORBANCE)) discard;   // before the other moments are fetched
    Moments moments = stored_moments(pixel);
    StoredFactor stored = packed_factor(factor_moments(biased_moments(moments, frame.parameters.y)));
    factor_1 = factor_texel(stored, 0);
#if FACTOR_FLOATS > 4
    factor_2 = factor_texel(stored, 1);
#endif
#if FACTOR_FLOATS > 8
    factor_3 = factor_texel(stored, 2);
#endif
}
