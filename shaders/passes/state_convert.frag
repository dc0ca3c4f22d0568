// state_convert.frag -- converts the state that the first pass stored to the format that later passes read.
#include "passes/blocks.glsl"
#include "shared/portable_math.glsl"
#include "shared/fragment.glsl"
#include "shared/random_bits.glsl"
#include "technique"
#include "passes/stored_state.glsl"

layout(location = 0) out vec4 converted_texels[STATE_TEXELS];

void main()
{
    PixelState state = converted(state_at(ivec2(gl_FragCoord.xy)), pixel_state_settings());
    UNROLL
    for (int i = 0; i < STATE_TEXELS; ++i)
        converted_texels[i] = vec4(state.f[4 * i], state.f[4 * i + 1], state.f[4 * i + 2], state.f[4 * i + 3]);
}
