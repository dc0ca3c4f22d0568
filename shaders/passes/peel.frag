// peel.frag -- one layer of depth peeling: of all fragments behind the layer before, the depth test keeps the nearest.
#include "passes/blocks.glsl"
#include "passes/shading.glsl"
#include "passes/transparent_fragment.glsl"

layout(binding = 0) uniform sampler2D previous_depth;   // window depth of the layer before; 0 for the first

layout(location = 0) out vec4 layer;   // colour times opacity, opacity

void main()
{
    float opacity = fragment_opacity();
    layer = vec4(shaded(object.color_opacity.rgb) * opacity, opacity);
    // Last: llvmpipe gets loops wrong that stand behind a discard, and reconstruction is full of them.
    if (gl_FragCoord.z <= texelFetch(previous_depth, ivec2(gl_FragCoord.xy), 0).x) discard;
}
