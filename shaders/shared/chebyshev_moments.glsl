// chebyshev_moments.glsl -- Chebyshev moments of the absorbance, b_k = sum of absorbance T_k(depth): generation, bias and matrix.
// They take the same memory as power moments and are summed by the same blending. They are never converted from power moments,
// because that would magnify rounding: T_8 has coefficients up to 256. MOMENT_COUNT m is 4, 6 or 8. Not in the papers;
// docs/equations.md derives it.

#include "line_basis.glsl"

/// b*_{i+1} = 0. Bias pulls towards the arcsine distribution, whose Chebyshev moments are 0 except for the zeroth.
FN float bias_moment(int i)
{
    return 0.0f;
}

/// Moments of one fragment: absorbance * (1, T_1(z), ..., T_m(z)). depth z in [-1, 1].
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

/// The biased moment b_k times unit. b_0 is not biased.
FN FloatPair scaled_moment(IN(BiasedMoments) biased, int k, float unit)
{
    return choose_pair(k == 0, make_pair(biased.b0 * unit, 0.0f), biased_moment(biased, max(k - 1, 0), unit));
}

/// Entry i >= j of the matrix of moments, times unit. With z = cos phi, T_k(z) = cos(k phi). So T_i T_j = (T_{i+j} + T_{i-j}) / 2,
/// and the entry is E[T_i T_j] = (b_{i+j} + b_{i-j}) / 2. E is the sum over the fragments, weighted by absorbance.
FN FloatPair matrix_entry(IN(BiasedMoments) biased, int i, int j, float unit)
{
    FloatPair sum = pair_difference(scaled_moment(biased, i + j, unit), negative_pair(scaled_moment(biased, i - j, unit)));
    return scaled_pair(sum, 0.5f);
}

/// The Chebyshev moment k of (1 - z^2) dmu, times unit. From z^2 = (T_2 + 1) / 2 follows
/// (1 - z^2) T_k = (2 T_k - T_{k+2} - T_{|k-2|}) / 4. k in 0..MOMENT_COUNT - 2.
FN FloatPair inner_moment(IN(BiasedMoments) biased, int k, float unit)
{
    FloatPair centre = scaled_moment(biased, k, 0.5f * unit);
    FloatPair above = scaled_moment(biased, k + 2, 0.25f * unit);
    FloatPair below = scaled_moment(biased, k < 2 ? 2 - k : k - 2, 0.25f * unit);
    return pair_difference(pair_difference(centre, above), below);
}

/// Entry i >= j of the matrix of moments of (1 - z^2) dmu, times unit. i < ORDER - 1.
FN FloatPair inner_entry(IN(BiasedMoments) biased, int i, int j, float unit)
{
    FloatPair sum = pair_difference(inner_moment(biased, i + j, unit), negative_pair(inner_moment(biased, i - j, unit)));
    return scaled_pair(sum, 0.5f);
}

/// The leading coefficient of T_k: 2^(k-1), and 1 for T_0. k in 0..4.
FN float leading_coefficient(int k)
{
    return k <= 1 ? 1.0f : (k == 2 ? 2.0f : (k == 3 ? 4.0f : 8.0f));
}

#include "line_factor.glsl"
#include "line_kernel.glsl"
