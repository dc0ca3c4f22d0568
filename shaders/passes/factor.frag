// factor.frag -- runs between the first and the second pass. It biases and factors the moments of a pixel once, for all of its
// fragments. Pixels without absorbance keep what they hold, because no pass reads it.
#include "passes/blocks.glsl"
#include "shared/portable_math.glsl"
#include "shared/fragment.glsl"
#include "technique"
#include "passes/moment_textures.glsl"
#include "shared/reconstruction.glsl"
#include "shared/ends.glsl"
#include "shared/fragment_estimate.glsl"
#include "passes/factor_texels.glsl"

layout(location = 0) out vec4 factor_1;
#if PIXEL_FACTOR_FLOATS > 4
layout(location = 1) out vec4 factor_2;
#endif
#if PIXEL_FACTOR_FLOATS > 8
layout(location = 2) out vec4 factor_3;
#endif
#if PIXEL_FACTOR_FLOATS > 12
layout(location = 3) out vec4 factor_4;
#endif

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (!(texelFetch(total_absorbance_texture, pixel, 0).x >= MIN_ABSORBANCE)) discard;   // before the other moments are fetched
    PixelFactorTexels texels = packed_pixel(factored(stored_moments(pixel), frame.parameters.y));
    factor_1 = texels.texel[0];
#if PIXEL_FACTOR_FLOATS > 4
    factor_2 = texels.texel[1];
#endif
#if PIXEL_FACTOR_FLOATS > 8
    factor_3 = texels.texel[2];
#endif
#if PIXEL_FACTOR_FLOATS > 12
    factor_4 = texels.texel[3];
#endif
}
