// caster.frag -- draws transparent casters into the map of the light, by additive blending. They are not tested against opaque
// casters, because light would leak along the silhouettes of these (paper, Section 6). In this pass the light is the eye.
#include "passes/blocks.glsl"
INVARIANT_IN vec3 eye_position;
#include "passes/transparent_fragment.glsl"
#include "passes/light_block.glsl"
#namespace transparent
#include "shared/portable_math.glsl"
#include "shared/fragment.glsl"
#include "technique"
#ifdef PIXEL_STATE
#include "passes/caster_state.glsl"
#else
#include "passes/caster_moments.glsl"
#endif
#endnamespace

layout(location = 0) out vec4 layers[CASTER_LAYERS];

void main()
{
    transparent_CasterSums sums = transparent_caster_sums(fragment_depth(), fragment_opacity(), light.reconstruction);
    UNROLL
    for (int layer = 0; layer < CASTER_LAYERS; ++layer)
        layers[layer] = vec4(sums.f[4 * layer], sums.f[4 * layer + 1], sums.f[4 * layer + 2], sums.f[4 * layer + 3]);
}
