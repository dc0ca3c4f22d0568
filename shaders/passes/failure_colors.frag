// failure_colors.frag -- draws the counts of failures.frag as an overlay: hatched vermilion where a reconstruction failed, yellow
// where a sum was clamped. The patterns differ, too, for people who cannot tell the colours apart.
layout(binding = 0) uniform sampler2D failed_clamped;

layout(location = 0) out vec4 color;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 count = texelFetch(failed_clamped, pixel, 0).xy;
    float stripe = ((pixel.x + pixel.y) & 7) < 5 ? 1.0 : 0.25;
    color = count.x > 0.5 ? vec4(0.835, 0.369, 0.0, 0.85 * stripe)
                          : (count.y > 0.5 ? vec4(0.941, 0.894, 0.259, 0.8) : vec4(0.0));
}
