// composite.frag -- composites the transparent over the opaque picture (paper, Section 3.4). The true weights sum to the coverage
// 1 - exp(-b_0). With UNCERTAIN, each weight is first moved by the same share of what is uncertain about it (docs/less_error.md).
#include "passes/blocks.glsl"
#include "shared/portable_math.glsl"
#include "shared/renormalization.glsl"

layout(binding = 0) uniform sampler2D opaque_texture;
layout(binding = 1) uniform sampler2D weighted_color_texture;
layout(binding = 2) uniform sampler2D total_absorbance_texture;
#ifdef UNCERTAIN
layout(binding = 8) uniform sampler2D uncertain_color_texture;
#endif

layout(location = 0) out vec4 color;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 opaque = texelFetch(opaque_texture, pixel, 0).rgb;
    vec4 weighted = texelFetch(weighted_color_texture, pixel, 0);
    float transmittance = portable_exp(-texelFetch(total_absorbance_texture, pixel, 0).x);
#ifdef UNCERTAIN
    vec4 uncertain = texelFetch(uncertain_color_texture, pixel, 0);
    weighted += moved_share(weighted.a, uncertain.a, 1.0 - transmittance) * uncertain;
#endif
    float scale = frame.parameters.z > 0.5 && weighted.a > 0.0 ? (1.0 - transmittance) / weighted.a : 1.0;   // paper, Eq. 2
    color = vec4(opaque * transmittance + weighted.rgb * scale, 1.0);
}
