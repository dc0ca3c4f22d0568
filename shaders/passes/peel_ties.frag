// peel_ties.frag -- all fragments of one layer, whose depths peel_depth.frag drew. The depth test keeps the fragments at these depths,
// and blending composites the later ones over the earlier ones.
#include "passes/blocks.glsl"
#include "passes/shading.glsl"
#include "passes/transparent_fragment.glsl"

layout(binding = 0) uniform sampler2D opaque_depth;

layout(location = 0) out vec4 layer;   // colour times opacity, opacity

void main()
{
    float opacity = fragment_opacity();
    layer = vec4(shaded(object.color_opacity.rgb) * opacity, opacity);
    // The discard comes last. llvmpipe computes loops after a discard wrongly, and reconstruction is full of loops.
    if (gl_FragCoord.z >= texelFetch(opaque_depth, ivec2(gl_FragCoord.xy), 0).x) discard;
}
