// shadow_hausdorff.glsl -- shadow maps of four moments, for depths that are known to lie within the depth range (Peters and Klein
// 2015). If the result for the whole line needs a surface outside of the range, there is a sharper result. MOMENT_COUNT is 4;
// MOMENT_BITS is 32.
#include "power_moments.glsl"

const float SHADOW_BIAS = 3.0e-7f;
const float SHADOW_PARAMETER = 0.0f;
#include "shadow_moments.glsl"

/// The share in front of x in [0, 1] of a distribution with masses at x, at one end of [0, 1] and at one free point. Its moments
/// are b1 to b4.
FN float end_supported_fraction(float b1, float b2, float b3, float b4, float x)
{
    PRECISE float free_point = ((b3 - b2) * x + b3 - b4) / ((b2 - b1) * x + b2 - b3);
    float end = x > free_point ? 1.0f : 0.0f;
    PRECISE float third = b3 - b1 - (free_point + 1.0f) * (b2 - b1);
    PRECISE float part = (b2 - b1 + third * (free_point - end - x) / (x * (x - free_point))) / (free_point - end);
    PRECISE float fraction = part + 1.0f - b1;
    return fraction;
}

/// True if all nodes z + 1/t lie within the depth range. A node with t = 0 is infinitely far away.
FN bool nodes_within(IN(Reconstruction) at_depth, float depth)
{
    bool within = true;
    UNROLL
    for (int l = 0; l < ROOT_COUNT; ++l)
    {
        PRECISE float scaled_node = depth * at_depth.t[l] + 1.0f;
        within = within && abs(scaled_node) <= abs(at_depth.t[l]);
    }
    return within;
}

FN float shadowed_fraction(IN(ShadowTexel) texel, float depth)
{
    BiasedMoments biased = region_moments(texel);
    Reconstruction at_depth = region_at(biased, depth);
    float on_line = share_in_front(at_depth);
    // Moments of (z + 1) / 2, which lies in [0, 1].
    PRECISE float m1 = biased.b[0] + biased.bias_delta[0];
    PRECISE float m2 = biased.b[1] + biased.bias_delta[1];
    PRECISE float m3 = biased.b[2] + biased.bias_delta[2];
    PRECISE float m4 = biased.b[3] + biased.bias_delta[3];
    PRECISE float b1 = 0.5f * (1.0f + m1);
    PRECISE float b2 = 0.25f * (1.0f + 2.0f * m1 + m2);
    PRECISE float b3 = 0.125f * (1.0f + 3.0f * m1 + 3.0f * m2 + m3);
    PRECISE float b4 = 0.0625f * (1.0f + 4.0f * m1 + 6.0f * m2 + 4.0f * m3 + m4);
    float within_range = number_in_unit_range(end_supported_fraction(b1, b2, b3, b4, 0.5f * (depth + 1.0f)));
    // The sharper result is never lighter. With one or two surfaces the matrix is nearly singular, and rounding alone made it up to
    // 7e-3 lighter.
    return nodes_within(at_depth, depth) ? on_line : max(within_range, on_line);
}
