// line_factor.glsl -- factors the matrix of moments on the line. Its entries are E[u_i u_j] for the polynomials u_k of the basis;
// for u_k = z^k it is the Hankel matrix. A basis defines matrix_entry, inner_entry and leading_coefficient before it includes this
// file.

struct Factor
{
    float b0;
    float a[ROOT_COUNT];       // a_k of the recurrence
    float ratio[ROOT_COUNT];   // h_k / h_{k-1}; [0] unused
    float inverse_h[ORDER];    // 1 / h_k; h_k = E[p_k^2] is the squared norm of p_k
    int floored;               // number of pivots that were raised to the floor
};

/// The factor with its ratios h_k / h_{k-1} for k < count; 0 for others. They follow from inverse_h, so they need not be stored.
FN Factor with_ratios_up_to(IN(Factor) factor, int count)
{
    Factor result = factor;
    UNROLL
    for (int k = 0; k < ROOT_COUNT; ++k)
        result.ratio[k] = k > 0 && k < count ? min(factor.inverse_h[max(k - 1, 0)] / factor.inverse_h[k], 1.0f) : 0.0f;
    return result;
}

FN Factor with_ratios(IN(Factor) factor)
{
    return with_ratios_up_to(factor, ROOT_COUNT);
}

/// What a pixel stores of its factor, so that the second pass need not factor again: a_k, then 1 / h_k for k > 0. h_0 is always 1.
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

/// b0: the total absorbance, which is stored separately.
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

/// Factors the matrix of biased moments, normalised to b_0 = 1, and returns the recurrence of the monic orthogonal polynomials p_k.
///
/// Elimination gives M = L D L^T with M_ij = E[u_i u_j]. So u_i = sum of L_ij q_j, where the q_k are orthogonal and E[q_k^2] = D_k.
/// If c_k is the leading coefficient of u_k, then p_k = q_k / c_k and h_k = E[p_k^2] = D_k / c_k^2. The recurrence
/// p_{k+1} = (z - a_k) p_k - (h_k / h_{k-1}) p_{k-1} gives a_k = s_k - s_{k+1}, where s_k is the coefficient of z^(k-1) in p_k. In
/// the u_k of both bases this coefficient is 0, so s_k = -L_{k,k-1} c_{k-1} / c_k.
///
/// Since depths lie in [-1, 1], |a_k| <= 1 and h_k <= h_{k-1} for every distribution. After rounding, moments may belong to no
/// distribution; then these limits keep the polynomials from overflowing.
///
/// inner: factors the matrix of the measure (1 - z^2) dmu instead (line_interval.glsl), which has one row less. Its h_0 is not 1.
FN Factor factor_matrix(IN(BiasedMoments) biased, bool inner)
{
    int order = inner ? ORDER - 1 : ORDER;
    FloatPair entry[ORDER * ORDER];    // (i, j) at i ORDER + j for i >= j: what elimination has left of M, times scale
    float lower[ORDER * ORDER];        // L; its diagonal is 1
    Factor factor;
    factor.b0 = biased.b0;
    factor.floored = 0;
    float unit = inverse_power_of_two(biased.b0);   // brings b_0 into [1, 2) without rounding, so no product underflows
    UNROLL
    for (int i = 0; i < ORDER; ++i)
    {
        UNROLL
        for (int j = 0; j <= i; ++j)
        {
            if (i >= order) continue;
            if (inner) entry[i * ORDER + j] = inner_entry(biased, min(i, ORDER - 2), min(j, ORDER - 2), unit);
            else entry[i * ORDER + j] = matrix_entry(biased, i, j, unit);
        }
    }
    float scale = biased.b0 * unit;
    UNROLL
    for (int k = 0; k < ORDER; ++k)
    {
        factor.inverse_h[k] = 0.0f;
        if (k >= order) continue;
        Pivot pivot = make_pivot(entry[k * ORDER + k], scale);
        factor.floored += pivot.floored;
        // The pivot is D_k = h_k c_k^2. c_k is a power of two, so the product below is exact.
        float leading = leading_coefficient(k);
        factor.inverse_h[k] = pivot.inverse_h * (leading * leading);
        UNROLL
        for (int i = k + 1; i < ORDER; ++i)
        {
            if (i >= order) continue;
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
        factor.a[k] = 0.0f;
        if (k + 1 >= order) continue;
        float up = leading_coefficient(k) / leading_coefficient(k + 1);
        PRECISE float a = lower[(k + 1) * ORDER + k] * up;
        if (k > 0)   // for k = 0 the term does not exist; a product with 0 could be NaN
        {
            float down = leading_coefficient(k - 1) / leading_coefficient(k);
            a = a - lower[k * ORDER + max(k - 1, 0)] * down;
        }
        factor.a[k] = clamp(a, -1.0f, 1.0f);
    }
    return with_ratios_up_to(factor, order - 1);
}

FN Factor factor_moments(IN(BiasedMoments) biased)
{
    return factor_matrix(biased, false);
}
