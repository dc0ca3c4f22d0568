// capture.frag -- appends every transparent fragment to its pixel's list; the count goes on past the capacity, so that
// the CPU learns how much was missing. WITH_TRANSMITTANCE adds what the second pass computes for it.
#include "passes/blocks.glsl"
#include "passes/shading.glsl"
#include "passes/transparent_fragment.glsl"
#include "passes/fragment_list.glsl"
#ifdef WITH_TRANSMITTANCE
#include "technique"
#ifdef PIXEL_STATE
#include "passes/stored_state.glsl"
#else
#include "passes/stored_moments.glsl"
#endif
#endif

layout(early_fragment_tests) in;

void main()
{
    float threshold = fragment_threshold();
    uint index = atomicAdd(fragment_list.count, 1u);
    if (index >= fragment_list.capacity) return;
    FragmentNode node;
    node.color_opacity = vec4(shaded(object.color_opacity.rgb), fragment_opacity());
    node.view_depth = fragment_view_depth();
    node.depth = fragment_depth();
#ifdef WITH_TRANSMITTANCE
    node.transmittance = fragment_transmittance();
#else
    node.transmittance = 0.0;
#endif
    node.draw = object.draw.x;
    node.primitive = uint(gl_PrimitiveID);
    node.pixel = fragment_pixel();
    node.threshold = threshold;
    node.next = imageAtomicExchange(list_heads, ivec2(gl_FragCoord.xy), index);
    fragment_list.nodes[index] = node;
}
