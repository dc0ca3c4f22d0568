// toeplitz_factor.glsl -- the factor of the Toeplitz matrix of trigonometric moments.

struct Factor
{
    Complex gamma[MOMENT_COUNT];           // Szego recurrence (Verblunsky) coefficients
    float inverse_h[ORDER];     // 1 / pivot, h_k = E[|p_k|^2]
    int floored;                           // how many pivots were raised to the floor
};

/// LDL^H of the Hermitian Toeplitz matrix G_ij = b_{i-j} of biased moments, normalised to b_0 = 1. Pivots come from this
/// elimination, not from h_k (1 - |gamma_k|^2), which loses the small ones.
///
/// Where fragments are few, nearly all of the matrix cancels in the elimination, and what is left, hardly more than the
/// bias, decides the result. So it runs on pairs of floats and without division (Bareiss): each step multiplies what is
/// left by its pivot, which `scale` keeps track of, and by a power of two that keeps it near 1.
///
/// No PRECISE here: glslangValidator takes forever to follow it through these arrays, and every sum that could be
/// re-associated is in a function that has it.
FN Factor factor_moments(IN(BiasedMoments) biased)
{
    FloatPair re[ORDER * ORDER];       // entry (i, j) at i ORDER + j for i >= j: the rest of G, times scale
    FloatPair im[ORDER * ORDER];
    Complex lower[ORDER * ORDER];      // L, with 1 on its diagonal
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
            int moment = 2 * max(i - j - 1, 0);
            re[i * ORDER + j] = i == j ? make_pair(biased.b0 * unit, 0.0f) : exact_sum(biased.b[moment] * unit, biased.pull[moment] * unit);
            im[i * ORDER + j] =
                i == j ? make_pair(0.0f, 0.0f) : exact_sum(biased.b[moment + 1] * unit, biased.pull[moment + 1] * unit);
        }
    }
    float scale = biased.b0 * unit;
    UNROLL
    for (int k = 0; k < ORDER; ++k)
    {
        float normalised_pivot = re[k * ORDER + k].high / scale;
        factor.floored += normalised_pivot < PIVOT_FLOOR ? 1 : 0;
        h[k] = max(normalised_pivot, PIVOT_FLOOR);
        factor.inverse_h[k] = 1.0f / h[k];
        FloatPair pivot = re[k * ORDER + k];
        float inverse_pivot = factor.inverse_h[k] / scale;
        if (normalised_pivot < PIVOT_FLOOR) pivot = make_pair(PIVOT_FLOOR * scale, 0.0f);
        float power_of_two = inverse_power_of_two(pivot.high);
        UNROLL
        for (int i = k + 1; i < ORDER; ++i)
        {
            FloatPair i_re = re[i * ORDER + k];
            FloatPair i_im = im[i * ORDER + k];
            lower[i * ORDER + k] = make_complex(i_re.high * inverse_pivot, i_im.high * inverse_pivot);
            UNROLL
            for (int j = k + 1; j <= i; ++j)
            {
                FloatPair j_re = re[j * ORDER + k];
                FloatPair j_im = im[j * ORDER + k];
                FloatPair j_im_minus = make_pair(-j_im.high, -j_im.low);
                re[i * ORDER + j] = scaled_pair(
                    pair_difference(pair_difference(pair_product(re[i * ORDER + j], pivot), pair_product(i_re, j_re)),
                                    pair_product(i_im, j_im)), power_of_two);
                if (i != j)
                    im[i * ORDER + j] = scaled_pair(
                        pair_difference(pair_difference(pair_product(im[i * ORDER + j], pivot),
                                                        pair_product(i_im, j_re)),
                                        pair_product(i_re, j_im_minus)), power_of_two);
            }
        }
        scale = scale * pivot.high * power_of_two;
    }
    // gamma_k = p_{k+1}(0), from x^i = sum_j L_ij p_j(x) at x = 0.
    Complex at_zero[ORDER];
    at_zero[0] = make_complex(1.0f, 0.0f);
    UNROLL
    for (int i = 1; i <= MOMENT_COUNT; ++i)
    {
        float sum_re = 0.0f;
        float sum_im = 0.0f;
        UNROLL
        for (int j = 0; j < i; ++j)
        {
            Complex term = product(lower[i * ORDER + j], at_zero[j]);
            sum_re = sum_re - term.re;
            sum_im = sum_im - term.im;
        }
        at_zero[i] = make_complex(sum_re, sum_im);
        factor.gamma[i - 1] = at_zero[i];
    }
    return factor;
}
