// capture.frag -- appends every transparent fragment to the list of its pixel. If the buffer is full, it still counts, so the CPU
// learns how much capacity was missing. With LAYERED it draws the fragment to three targets instead, and the stencil chooses which
// fragment of a pixel that is (core/render/peeled_fragments.hpp). With WITH_TRANSMITTANCE it stores beside each fragment the T that
// the second pass computes for it.
#include "passes/blocks.glsl"
#include "passes/shading.glsl"
#include "passes/transparent_fragment.glsl"
#ifdef LAYERED
layout(binding = 11) uniform sampler2D opaque_depth_texture;
layout(location = 0) out vec4 captured_color;     // colour, opacity
layout(location = 1) out vec4 captured_depths;    // view depth, depth, T, threshold
layout(location = 2) out vec4 captured_numbers;   // draw call, triangle; 1 if no opaque surface hides it; 1
#else
#include "passes/fragment_list.glsl"
#endif
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

EARLY_TESTS

void main()
{
    // Before any branch, because thresholds take derivatives and these need the whole quad.
    float threshold = fragment_threshold();
#ifdef WITH_TRANSMITTANCE
    float transmittance = fragment_transmittance();
#else
    float transmittance = 0.0;
#endif
#ifdef LAYERED
#ifdef NO_PRIMITIVE_IDS
    float primitive = 0.0;
#else
    float primitive = float(gl_PrimitiveID);
#endif
    bool hidden = gl_FragCoord.z >= texelFetch(opaque_depth_texture, ivec2(gl_FragCoord.xy), 0).x;
    captured_color = vec4(shaded(object.color_opacity.rgb), fragment_opacity());
    captured_depths = vec4(fragment_view_depth(), fragment_depth(), transmittance, threshold);
    captured_numbers = vec4(float(object.draw.x), primitive, hidden ? 0.0 : 1.0, 1.0);
#else
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
#endif
}
