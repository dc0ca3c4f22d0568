// state_composite.frag -- composites the transparent over the opaque picture, for techniques without moments.
#include "passes/blocks.glsl"
#include "shared/portable_math.glsl"
#include "shared/fragment.glsl"
#include "shared/random_bits.glsl"
#include "technique"
#include "passes/stored_state.glsl"

layout(binding = 0) uniform sampler2D opaque_texture;
layout(binding = 1) uniform sampler2D weighted_color_texture;
#ifdef EXACT_ABSORBANCE_SLOT
layout(binding = 10) uniform sampler2D exact_absorbance_texture;
#endif

layout(location = 0) out vec4 color;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 opaque = texelFetch(opaque_texture, pixel, 0).rgb;
    PixelState state = stored_state(pixel);
#ifdef EXACT_ABSORBANCE_SLOT
    state.f[EXACT_ABSORBANCE_SLOT] = texelFetch(exact_absorbance_texture, pixel, 0).x;
#endif
    Composited all = composited(state, pixel_state_settings());
#ifdef HOLDS_COLORS
    vec3 transparent_color = vec3(all.red, all.green, all.blue);
#else
    vec4 weighted = texelFetch(weighted_color_texture, pixel, 0);
    float scale = frame.parameters.z > 0.5 && weighted.a > 0.0 ? (1.0 - all.transmittance) / weighted.a : 1.0;   // paper, Eq. 2
    vec3 transparent_color = weighted.rgb * scale;
#endif
    color = vec4(opaque * all.transmittance + transparent_color, 1.0);
}
