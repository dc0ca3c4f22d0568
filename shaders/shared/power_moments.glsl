// power_moments.glsl -- power moments of the absorbance (paper, Section 4): generation, bias and matrix. MOMENT_COUNT m is 4, 6 or
// 8; MOMENT_BITS is 16 or 32.

#define ALGORITHM_1   // see textbook.glsl
#include "line_basis.glsl"

#if MOMENT_BITS == 16
#define THETA_TRANSFORM   // see unorm16_storage.glsl
#if MOMENT_COUNT == 4     // b* for moments stored in 16 bits (supplementary, Table 1)
const float BIAS_MOMENTS[4] = {0.0f, 0.628f, 0.0f, 0.628f};
#elif MOMENT_COUNT == 6
const float BIAS_MOMENTS[6] = {0.0f, 0.5566f, 0.0f, 0.489f, 0.0f, 0.47869382f};
#else
const float BIAS_MOMENTS[8] = {0.0f, 0.424749164f, 0.0f, 0.224078027f, 0.0f, 0.153692308f, 0.0f, 0.129004405f};
#endif
#elif MOMENT_COUNT == 4   // b* for moments stored in floats (supplementary, Table 1)
const float BIAS_MOMENTS[4] = {0.0f, 0.375f, 0.0f, 0.375f};
#elif MOMENT_COUNT == 6
const float BIAS_MOMENTS[6] = {0.0f, 0.48f, 0.0f, 0.451f, 0.0f, 0.45f};
#else
const float BIAS_MOMENTS[8] = {0.0f, 0.75f, 0.0f, 0.676666667f, 0.0f, 0.63f, 0.0f, 0.60030303f};
#endif

/// b*_{i+1}. Bias pulls the moments towards these.
FN float bias_moment(int i)
{
    return BIAS_MOMENTS[i];
}

/// Moments of one fragment: absorbance * (1, z, ..., z^m). depth z in [-1, 1].
FN Moments fragment_moments(float depth, float absorbance, IN(Basis) basis)
{
    Moments moments;
    moments.b0 = absorbance;
    PRECISE float power = absorbance;
    UNROLL
    for (int i = 0; i < MOMENT_FLOATS; ++i)
    {
        power = power * depth;
        moments.b[i] = power;
    }
    return moments;
}

/// The biased moment b_k times unit. b_0 is not biased.
FN FloatPair scaled_moment(IN(BiasedMoments) biased, int k, float unit)
{
    return choose_pair(k == 0, make_pair(biased.b0 * unit, 0.0f), biased_moment(biased, max(k - 1, 0), unit));
}

/// Entry i >= j of the Hankel matrix H_ij = b_{i+j}, times unit.
FN FloatPair matrix_entry(IN(BiasedMoments) biased, int i, int j, float unit)
{
    return scaled_moment(biased, i + j, unit);
}

/// Entry i >= j of the Hankel matrix of (1 - z^2) dmu, which has the moments b_k - b_{k+2}, times unit. i < ORDER - 1.
FN FloatPair inner_entry(IN(BiasedMoments) biased, int i, int j, float unit)
{
    return pair_difference(scaled_moment(biased, i + j, unit), scaled_moment(biased, i + j + 2, unit));
}

/// The leading coefficient of the k-th polynomial of the basis: 1, because it is z^k.
FN float leading_coefficient(int k)
{
    return 1.0f;
}

#include "line_factor.glsl"
#include "line_kernel.glsl"
