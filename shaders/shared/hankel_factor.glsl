// hankel_factor.glsl -- the factor of the Hankel matrix of power moments.

struct Factor
{
    float a[ROOT_COUNT];               // recurrence, diagonal
    float ratio[ROOT_COUNT];           // h_k / h_{k-1}; [0] unused
    float inverse_h[ORDER];   // 1 / pivot
    int floored;                       // how many pivots were raised to the floor
};

/// LDL^T of the Hankel matrix of biased moments, normalised to b_0 = 1.
///
/// Where fragments are few, nearly all of the matrix cancels in the elimination, and what is left, hardly more than the
/// bias, decides the result. So it runs on pairs of floats and without division (Bareiss): each step multiplies what is
/// left by its pivot, which `scale` keeps track of, and by a power of two that keeps it near 1.
FN Factor factor_moments(IN(BiasedMoments) biased)
{
    FloatPair entry[ORDER * ORDER];    // entry[i ORDER + j] for i >= j: the rest of H, times scale
    float lower[ORDER * ORDER];        // L, with 1 on its diagonal
    float h[ORDER];
    Factor factor;
    factor.floored = 0;
    float unit = inverse_power_of_two(biased.b0);   // brings b_0 into [1, 2) exactly, so that no product underflows
    UNROLL
    for (int i = 0; i < ORDER; ++i)
    {
        UNROLL
        for (int j = 0; j <= i; ++j)
        {
            int moment = max(i + j - 1, 0);
            entry[i * ORDER + j] =
                i == 0 ? make_pair(biased.b0 * unit, 0.0f) : exact_sum(biased.b[moment] * unit, biased.pull[moment] * unit);
        }
    }
    PRECISE float scale = biased.b0 * unit;
    UNROLL
    for (int k = 0; k < ORDER; ++k)
    {
        PRECISE float normalised_pivot = entry[k * ORDER + k].high / scale;
        factor.floored += normalised_pivot < PIVOT_FLOOR ? 1 : 0;
        h[k] = max(normalised_pivot, PIVOT_FLOOR);
        factor.inverse_h[k] = 1.0f / h[k];
        FloatPair pivot = entry[k * ORDER + k];
        PRECISE float inverse_pivot = factor.inverse_h[k] / scale;
        if (normalised_pivot < PIVOT_FLOOR) pivot = make_pair(PIVOT_FLOOR * scale, 0.0f);
        float power_of_two = inverse_power_of_two(pivot.high);
        UNROLL
        for (int i = k + 1; i < ORDER; ++i)
        {
            lower[i * ORDER + k] = entry[i * ORDER + k].high * inverse_pivot;
            UNROLL
            for (int j = k + 1; j <= i; ++j)
                entry[i * ORDER + j] = scaled_pair(
                    pair_difference(pair_product(entry[i * ORDER + j], pivot),
                                    pair_product(entry[i * ORDER + k], entry[j * ORDER + k])),
                    power_of_two);
        }
        scale = scale * pivot.high * power_of_two;
    }
    UNROLL
    for (int k = 0; k < ROOT_COUNT; ++k)
    {
        float before = k == 0 ? 0.0f : lower[k * ORDER + max(k - 1, 0)];
        factor.a[k] = lower[(k + 1) * ORDER + k] - before;
        factor.ratio[k] = k == 0 ? 0.0f : h[k] * factor.inverse_h[max(k - 1, 0)];
    }
    return factor;
}
