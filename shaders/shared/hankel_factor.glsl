// hankel_factor.glsl -- the factor of the Hankel matrix of power moments.

struct Factor
{
    float a[ROOT_COUNT];       // recurrence, diagonal
    float ratio[ROOT_COUNT];   // h_k / h_{k-1}; [0] unused
    float inverse_h[ORDER];    // 1 / pivot
    int floored;               // how many pivots were raised to the floor
};

/// LDL^T of the Hankel matrix of biased moments, normalised to b_0 = 1.
FN Factor factor_moments(IN(BiasedMoments) biased)
{
    FloatPair entry[ORDER * ORDER];    // entry[i ORDER + j] for i >= j: the rest of H, times scale
    float lower[ORDER * ORDER];        // L, with 1 on its diagonal
    Factor factor;
    factor.floored = 0;
    float unit = inverse_power_of_two(biased.b0);   // brings b_0 into [1, 2) exactly, so that no product underflows
    UNROLL
    for (int i = 0; i < ORDER; ++i)
    {
        UNROLL
        for (int j = 0; j <= i; ++j)
            entry[i * ORDER + j] =
                i == 0 ? make_pair(biased.b0 * unit, 0.0f) : biased_moment(biased, max(i + j - 1, 0), unit);
    }
    float scale = biased.b0 * unit;
    float previous_h = 1.0f;
    UNROLL
    for (int k = 0; k < ORDER; ++k)
    {
        Pivot pivot = make_pivot(entry[k * ORDER + k], scale);
        factor.floored += pivot.floored;
        factor.inverse_h[k] = pivot.inverse_h;
        if (k < ROOT_COUNT) factor.ratio[min(k, ROOT_COUNT - 1)] = k == 0 ? 0.0f : pivot.h / previous_h;
        previous_h = pivot.h;
        PRECISE float inverse_pivot = pivot.inverse_h / scale;
        UNROLL
        for (int i = k + 1; i < ORDER; ++i)
        {
            lower[i * ORDER + k] = entry[i * ORDER + k].high * inverse_pivot;
            UNROLL
            for (int j = k + 1; j <= i; ++j)
                entry[i * ORDER + j] =
                    eliminated(entry[i * ORDER + j], pivot, entry[i * ORDER + k], entry[j * ORDER + k]);
        }
        scale = next_scale(scale, pivot);
    }
    UNROLL
    for (int k = 0; k < ROOT_COUNT; ++k)
        factor.a[k] = lower[(k + 1) * ORDER + k] - (k == 0 ? 0.0f : lower[k * ORDER + max(k - 1, 0)]);
    return factor;
}
