// chebyshev_moments.glsl -- Chebyshev moments of the absorbance, b_k = sum of absorbance T_k(depth): generation, bias and
// their matrix. The same memory and additive blending as power moments, but no basis change to magnify rounding: T_8 has
// coefficients up to 256. MOMENT_COUNT m is 4, 6 or 8. Not in the papers; docs/equations.md derives it.

#include "line_basis.glsl"

/// b*_{i+1} = 0, towards which bias pulls: the arcsine distribution, whose Chebyshev moments vanish.
FN float bias_moment(int i)
{
    return 0.0f;
}

/// Moments of one fragment, absorbance * (1, T_1(z), ..., T_m(z)). depth z in [-1, 1].
FN Moments fragment_moments(float depth, float absorbance, IN(Basis) basis)
{
    Moments moments;
    moments.b0 = absorbance;
    PRECISE float before = 1.0f;
    PRECISE float now = depth;
    UNROLL
    for (int i = 0; i < MOMENT_FLOATS; ++i)
    {
        moments.b[i] = absorbance * now;
        PRECISE float next = 2.0f * depth * now - before;
        before = now;
        now = next;
    }
    return moments;
}

/// t_k of biased moments times unit; t_0 is not biased.
FN FloatPair scaled_moment(IN(BiasedMoments) biased, int k, float unit)
{
    return k == 0 ? make_pair(biased.b0 * unit, 0.0f) : biased_moment(biased, max(k - 1, 0), unit);
}

/// Entry i >= j of the matrix E[T_i T_j] = (t_{i+j} + t_{i-j}) / 2, of moments times unit.
FN FloatPair matrix_entry(IN(BiasedMoments) biased, int i, int j, float unit)
{
    FloatPair sum = pair_difference(scaled_moment(biased, i + j, unit), negative_pair(scaled_moment(biased, i - j, unit)));
    return scaled_pair(sum, 0.5f);
}

/// Leading coefficient of T_k: 2^(k-1), and 1 for T_0.
FN float leading_coefficient(int k)
{
    return k <= 1 ? 1.0f : (k == 2 ? 2.0f : (k == 3 ? 4.0f : 8.0f));
}

#include "line_factor.glsl"
#include "line_kernel.glsl"
