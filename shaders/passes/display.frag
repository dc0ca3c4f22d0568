// display.frag -- applies the tone map to the linear picture and converts it to sRGB for the screen.
#include "shared/tone_map.glsl"

uniform int tone_map;
layout(binding = 0) uniform sampler2D picture;

layout(location = 0) out vec4 color;

void main()
{
    vec3 scene = max(texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb, 0.0);
    vec3 linear = min(vec3(tone_mapped(scene.r, tone_map), tone_mapped(scene.g, tone_map),
                           tone_mapped(scene.b, tone_map)), 1.0);
    vec3 low = 12.92 * linear;
    vec3 high = 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055;
    color = vec4(mix(high, low, lessThanEqual(linear, vec3(0.0031308))), 1.0);
}
