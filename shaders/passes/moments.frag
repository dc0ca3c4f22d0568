// moments.frag -- first pass: moments of the absorbance, summed by additive blending (Section 3.1).
#include "passes/blocks.glsl"
#include "passes/shading.glsl"
#include "passes/transparent_fragment.glsl"
#include "technique"

layout(early_fragment_tests) in;

layout(location = 0) out float total_absorbance;
layout(location = 1) out vec4 moments_1_to_4;
#if MOMENT_FLOATS == 6
layout(location = 2) out vec2 moments_5_to_6;
#elif MOMENT_FLOATS == 8
layout(location = 2) out vec4 moments_5_to_8;
#endif

void main()
{
    Basis basis = make_basis(frame.parameters.y);
    Moments moments =
        fragment_moments(fragment_depth(), absorbance_of_opacity(object.color_opacity.a), basis);
    total_absorbance = moments.b0;
    moments_1_to_4 = vec4(moments.b[0], moments.b[1], moments.b[2], moments.b[3]);
#if MOMENT_FLOATS == 6
    moments_5_to_6 = vec2(moments.b[4], moments.b[5]);
#elif MOMENT_FLOATS == 8
    moments_5_to_8 = vec4(moments.b[4], moments.b[5], moments.b[6], moments.b[7]);
#endif
}
