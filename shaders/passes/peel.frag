// peel.frag -- one layer of depth peeling. Of all fragments behind the previous layer, the depth test keeps the nearest.
#include "passes/blocks.glsl"
#include "passes/shading.glsl"
#include "passes/transparent_fragment.glsl"

layout(binding = 0) uniform sampler2D previous_depth;   // window depth of the previous layer; 0 for the first layer

layout(location = 0) out vec4 layer;   // colour times opacity, opacity

void main()
{
    float opacity = fragment_opacity();
    layer = vec4(shaded(object.color_opacity.rgb) * opacity, opacity);
    // The discard comes last. llvmpipe computes loops after a discard wrongly, and reconstruction is full of loops.
    if (gl_FragCoord.z <= texelFetch(previous_depth, ivec2(gl_FragCoord.xy), 0).x) discard;
}
