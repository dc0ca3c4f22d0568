// factor.frag -- runs between the first and the second pass. It biases and factors the moments of a pixel once, for all of its
// fragments. Later passes read only b_0 of pixels without absorbance.
#include "passes/blocks.glsl"
#include "shared/portable_math.glsl"
#include "shared/fragment.glsl"
#include "technique"
#include "passes/moment_textures.glsl"
#include "shared/reconstruction.glsl"
#include "passes/pixel_ends.glsl"
#include "shared/fragment_estimate.glsl"
#include "passes/factor_texels.glsl"

#ifndef FIRST_TEXEL   // a GL may have fewer targets than there are texels
#define FIRST_TEXEL 0
#define WRITTEN_TEXELS PIXEL_FACTOR_TEXELS
#endif
layout(location = 0) out vec4 factor_texels[WRITTEN_TEXELS];

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    bool empty = !(texelFetch(total_absorbance_texture, pixel, 0).x >= MIN_ABSORBANCE);
#ifndef KNOWN_ENDS
    if (empty) discard;   // before the other moments are fetched
#endif
    PixelFactorTexels texels;
    if (empty)
        for (int i = 0; i < PIXEL_FACTOR_TEXELS; ++i) texels.texel[i] = vec4(0.0);
    else texels = packed_pixel(factored(stored_moments(pixel), stored_ends(pixel), frame.parameters.y));
    UNROLL
    for (int i = 0; i < WRITTEN_TEXELS; ++i) factor_texels[i] = texels.texel[FIRST_TEXEL + i];
}
