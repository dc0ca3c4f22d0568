// fragment_list.glsl -- all transparent fragments, one linked list per pixel (Yang et al. 2010).

struct FragmentNode
{
    vec4 color_opacity;
    float view_depth;
    float depth;
    float transmittance;   // T of the second pass, with WITH_TRANSMITTANCE
    uint draw;
    uint primitive;
    uint next;             // index of the next fragment of the pixel, or END_OF_LIST
    uint pixel;            // x + 65536 y
    float threshold;       // of hashed alpha testing
};

const uint END_OF_LIST = 0xffffffffu;

layout(std430, binding = 0) buffer FragmentList
{
    uint count;            // number of fragments drawn, stored or not
    uint capacity;
    uint padding[2];
    FragmentNode nodes[];
} fragment_list;

layout(binding = 0, r32ui) uniform coherent uimage2D list_heads;
