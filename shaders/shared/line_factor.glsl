// line_factor.glsl -- the factor of the matrix of moments of a measure on the line: E[u_i u_j] for the polynomials u_k of
// the basis, which is the Hankel matrix for u_k = z^k. A basis defines matrix_entry and leading_coefficient before.

struct Factor
{
    float b0;
    float a[ROOT_COUNT];       // recurrence, diagonal
    float ratio[ROOT_COUNT];   // h_k / h_{k-1}; [0] unused
    float inverse_h[ORDER];    // 1 / pivot
    int floored;               // how many pivots were raised to the floor
};

/// h_k / h_{k-1} from the pivots, which is all of the factor that need not be stored.
FN Factor with_ratios(IN(Factor) factor)
{
    Factor result = factor;
    result.ratio[0] = 0.0f;
    UNROLL
    for (int k = 1; k < ROOT_COUNT; ++k) result.ratio[k] = min(factor.inverse_h[k - 1] / factor.inverse_h[k], 1.0f);
    return result;
}

/// What a pixel stores of its factor, so that the second pass need not factor again: a_k, then 1 / h_k for k > 0, and
/// h_0 = 1 always.
#define FACTOR_FLOATS (2 * ROOT_COUNT)
struct StoredFactor { float x[FACTOR_FLOATS]; };

FN StoredFactor packed_factor(IN(Factor) factor)
{
    StoredFactor stored;
    UNROLL
    for (int k = 0; k < ROOT_COUNT; ++k)
    {
        stored.x[k] = factor.a[k];
        stored.x[ROOT_COUNT + k] = factor.inverse_h[k + 1];
    }
    return stored;
}

/// b0: the total absorbance, which stands beside it.
FN Factor unpacked_factor(IN(StoredFactor) stored, float b0)
{
    Factor factor;
    factor.b0 = b0;
    factor.floored = 0;
    factor.inverse_h[0] = 1.0f;
    UNROLL
    for (int k = 0; k < ROOT_COUNT; ++k)
    {
        factor.a[k] = stored.x[k];
        factor.inverse_h[k + 1] = stored.x[ROOT_COUNT + k];
    }
    return with_ratios(factor);
}

/// LDL^T of the matrix of biased moments, normalised to b_0 = 1, as the recurrence of the monic orthogonal polynomials.
/// Depths lie in [-1, 1], so that |a_k| <= 1 and h_k <= h_{k-1} for every measure. Where rounding leaves moments that no
/// measure has, these limits keep the polynomials from overflowing.
FN Factor factor_moments(IN(BiasedMoments) biased)
{
    FloatPair entry[ORDER * ORDER];    // entry[i ORDER + j] for i >= j: the rest of H, times scale
    float lower[ORDER * ORDER];        // L, with 1 on its diagonal
    Factor factor;
    factor.b0 = biased.b0;
    factor.floored = 0;
    float unit = inverse_power_of_two(biased.b0);   // brings b_0 into [1, 2) exactly, so that no product underflows
    UNROLL
    for (int i = 0; i < ORDER; ++i)
    {
        UNROLL
        for (int j = 0; j <= i; ++j)
            entry[i * ORDER + j] = matrix_entry(biased, i, j, unit);
    }
    float scale = biased.b0 * unit;
    UNROLL
    for (int k = 0; k < ORDER; ++k)
    {
        Pivot pivot = make_pivot(entry[k * ORDER + k], scale);
        factor.floored += pivot.floored;
        // The pivot is the norm of the k-th orthogonal polynomial with the basis's leading coefficient, a power of two.
        float leading = leading_coefficient(k);
        factor.inverse_h[k] = pivot.inverse_h * (leading * leading);
        UNROLL
        for (int i = k + 1; i < ORDER; ++i)
        {
            lower[i * ORDER + k] = entry[i * ORDER + k].high * pivot.inverse;
            UNROLL
            for (int j = k + 1; j <= i; ++j)
                entry[i * ORDER + j] =
                    eliminated(entry[i * ORDER + j], pivot, entry[i * ORDER + k], entry[j * ORDER + k]);
        }
        scale = next_scale(scale, pivot);
    }
    UNROLL
    for (int k = 0; k < ROOT_COUNT; ++k)
    {
        float up = leading_coefficient(k) / leading_coefficient(k + 1);
        PRECISE float a = lower[(k + 1) * ORDER + k] * up;
        if (k > 0)   // nothing stands left of the first diagonal entry, and nothing times 0 may be NaN
        {
            float down = leading_coefficient(k - 1) / leading_coefficient(k);
            a = a - lower[k * ORDER + max(k - 1, 0)] * down;
        }
        factor.a[k] = clamp(a, -1.0f, 1.0f);
    }
    return with_ratios(factor);
}
