// peel_composite.frag -- composites the peeled layers, which were blended front to back, over the opaque picture (paper, Eq. 1).
layout(binding = 0) uniform sampler2D opaque_texture;
layout(binding = 1) uniform sampler2D layers;   // sum of colours; transmittance behind the last layer

layout(location = 0) out vec4 color;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 front = texelFetch(layers, pixel, 0);
    color = vec4(front.rgb + texelFetch(opaque_texture, pixel, 0).rgb * front.a, 1.0);
}
