// capture.frag -- appends every transparent fragment to the list of its pixel. If the buffer is full, it still counts, so the CPU
// learns how much capacity was missing. With WITH_TRANSMITTANCE it stores beside each fragment the T that the second pass computes
// for it.
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
#ifdef WITH_LIGHT
// The share of the light that reaches the fragment, which takes the place of T.
float fragment_transmittance()
{
    return light_visibility(eye_position, fragment_absorbance());
}
#define WITH_TRANSMITTANCE 1
#endif

layout(early_fragment_tests) in;

void main()
{
    // Before any branch, because thresholds take derivatives and these need the whole quad.
    float threshold = fragment_threshold();
#ifdef WITH_TRANSMITTANCE
    float transmittance = fragment_transmittance();
#else
    float transmittance = 0.0;
#endif
    uint index = atomicAdd(fragment_list.count, 1u);
    if (index >= fragment_list.capacity) return;
    FragmentNode node;
    node.color_opacity = vec4(shaded(object.color_opacity.rgb), fragment_opacity());
    node.view_depth = fragment_view_depth();
    node.depth = fragment_depth();
    node.transmittance = transmittance;
    node.draw = object.draw.x;
    node.primitive = uint(gl_PrimitiveID);
    node.pixel = fragment_pixel();
    node.threshold = threshold;
    node.next = imageAtomicExchange(list_heads, ivec2(gl_FragCoord.xy), index);
    fragment_list.nodes[index] = node;
}
