// display.frag -- linear picture to 8-bit sRGB for the screen.
layout(binding = 0) uniform sampler2D picture;

layout(location = 0) out vec4 color;

void main()
{
    vec3 linear = clamp(texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb, 0.0, 1.0);
    vec3 low = 12.92 * linear;
    vec3 high = 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055;
    color = vec4(mix(high, low, lessThanEqual(linear, vec3(0.0031308))), 1.0);
}
