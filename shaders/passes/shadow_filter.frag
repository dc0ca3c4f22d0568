// shadow_filter.frag -- filters one layer of a shadow map by a Gaussian in one direction. With OPAQUE_DEPTHS it reads depths of
// opaque casters and converts them to texels first.
#include "passes/light_block.glsl"

uniform ivec2 direction;   // (1, 0) or (0, 1)
#ifdef OPAQUE_DEPTHS
layout(binding = 0) uniform sampler2D depths;
#namespace opaque
#include "shared/portable_math.glsl"
#include "technique"
#endnamespace
#else
uniform int layer;
layout(binding = 0) uniform sampler2DArray sums;
#endif

layout(location = 0) out vec4 filtered;

vec4 value_at(ivec2 texel)
{
#ifdef OPAQUE_DEPTHS
    opaque_ShadowTexel made = opaque_shadow_texel(texelFetch(depths, texel, 0).x);
    return vec4(made.f[0], made.f[1], made.f[2], made.f[3]);
#else
    return texelFetch(sums, ivec3(texel, layer), 0);
#endif
}

void main()
{
    ivec2 last = ivec2(int(light.range.z) - 1);
    vec4 sum = vec4(0.0);
    for (int k = -light.radius.x; k <= light.radius.x; ++k)
    {
        int at = k + light.radius.x;
        sum += light.weights[at / 4][at % 4] * value_at(clamp(ivec2(gl_FragCoord.xy) + k * direction, ivec2(0), last));
    }
    filtered = sum;
}
