// blend_only.frag -- for first_pass_bench: blends opacities into as many numbers as the first pass of a technique, but computes
// nothing from them. If the scene has alpha maps, both must read them.
#include "passes/blocks.glsl"
#include "passes/shading.glsl"
#include "passes/transparent_fragment.glsl"

EARLY_TESTS

layout(location = 0) out vec4 total_absorbance;
layout(location = 1) out vec4 moments_1_to_4;
layout(location = 2) out vec4 moments_5_to_8;

void main()
{
    vec4 opacity = vec4(fragment_opacity());
    total_absorbance = opacity;
    moments_1_to_4 = opacity;
    moments_5_to_8 = opacity;
}
