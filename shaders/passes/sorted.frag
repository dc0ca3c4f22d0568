// sorted.frag -- ground truth: composites the fragments of a pixel front to back over the opaque picture (paper, Eq. 1). It selects
// the next fragment of the list again and again, so lists of any length need no local memory. Fragments at the same depth go in
// submission order: the one that was drawn later lies on top, as with alpha blending.
#include "passes/fragment_list.glsl"

layout(binding = 0) uniform sampler2D opaque_texture;

layout(location = 0) out vec4 color;

/// True if a lies in front of b. A strict order of all fragments of a pixel.
bool in_front(FragmentNode a, FragmentNode b)
{
    if (a.view_depth != b.view_depth) return a.view_depth < b.view_depth;
    if (a.draw != b.draw) return a.draw > b.draw;
    return a.primitive > b.primitive;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    // Lanes that cover no pixel may read zeros everywhere. Then node 0 would follow node 0, and the list would be endless.
    uint head = gl_HelperInvocation ? END_OF_LIST : imageLoad(list_heads, pixel).x;
    vec3 sum = vec3(0.0);
    float transmittance = 1.0;
    uint last = END_OF_LIST;
    while (true)
    {
        uint next = END_OF_LIST;
        for (uint i = head; i != END_OF_LIST; i = fragment_list.nodes[i].next)
        {
            if (last != END_OF_LIST && !in_front(fragment_list.nodes[last], fragment_list.nodes[i])) continue;
            if (next == END_OF_LIST || in_front(fragment_list.nodes[i], fragment_list.nodes[next])) next = i;
        }
        if (next == END_OF_LIST) break;
        vec4 fragment = fragment_list.nodes[next].color_opacity;
        sum += fragment.rgb * (fragment.a * transmittance);
        transmittance *= 1.0 - fragment.a;
        last = next;
    }
    color = vec4(sum + texelFetch(opaque_texture, pixel, 0).rgb * transmittance, 1.0);
}
