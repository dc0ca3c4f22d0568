// blend_only.frag -- for first_pass_bench: blends as many numbers as the first pass of a technique, and computes none of them.
#include "passes/blocks.glsl"

layout(early_fragment_tests) in;

layout(location = 0) out vec4 total_absorbance;
layout(location = 1) out vec4 moments_1_to_4;
layout(location = 2) out vec4 moments_5_to_8;

void main()
{
    vec4 anything = vec4(object.color_opacity.a);
    total_absorbance = anything;
    moments_1_to_4 = anything;
    moments_5_to_8 = anything;
}
