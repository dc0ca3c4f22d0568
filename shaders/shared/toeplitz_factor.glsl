// toeplitz_factor.glsl -- the factor of the Toeplitz matrix of trigonometric moments.
//
// No PRECISE here: glslangValidator takes forever to follow it through these arrays, and every sum that could be
// re-associated is in a function that has it.

struct Factor
{
    float b0;
    Complex gamma[MOMENT_COUNT];   // Szego recurrence (Verblunsky) coefficients
    float inverse_h[ORDER];        // 1 / pivot, h_k = E[|p_k|^2]
    int floored;                   // how many pivots were raised to the floor
};

/// What a pixel stores of its factor, so that the second pass need not factor again: gamma_k, then 1 / h_k for k > 0, and
/// h_0 = 1 always.
#define FACTOR_FLOATS (3 * MOMENT_COUNT)
struct StoredFactor { float x[FACTOR_FLOATS]; };

FN StoredFactor packed_factor(IN(Factor) factor)
{
    StoredFactor stored;
    UNROLL
    for (int k = 0; k < MOMENT_COUNT; ++k)
    {
        stored.x[2 * k] = factor.gamma[k].re;
        stored.x[2 * k + 1] = factor.gamma[k].im;
        stored.x[2 * MOMENT_COUNT + k] = factor.inverse_h[k + 1];
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
    for (int k = 0; k < MOMENT_COUNT; ++k)
    {
        factor.gamma[k] = make_complex(stored.x[2 * k], stored.x[2 * k + 1]);
        factor.inverse_h[k + 1] = stored.x[2 * MOMENT_COUNT + k];
    }
    return factor;
}

struct LowerMatrix { Complex entry[ORDER * ORDER]; };   // entry (i, j) at i ORDER + j for i > j; 1 on the diagonal

/// x, moved to the unit circle if it lies beyond. Verblunsky coefficients of a measure never do; those of moments that no
/// measure has, because rounding spoilt them, would let the polynomials overflow.
FN Complex within_unit_disc(IN(Complex) x)
{
    PRECISE float length2 = x.re * x.re + x.im * x.im;
    PRECISE float inverse_length = 1.0f / sqrt(max(length2, 1.0f));
    return make_complex(x.re * inverse_length, x.im * inverse_length);
}

/// gamma_k = p_{k+1}(0), from x^i = sum_j L_ij p_j(x) at x = 0.
FN Factor with_recurrence(IN(Factor) pivots, IN(LowerMatrix) lower)
{
    Factor factor = pivots;
    Complex at_zero[ORDER];
    at_zero[0] = make_complex(1.0f, 0.0f);
    UNROLL
    for (int i = 1; i < ORDER; ++i)
    {
        float sum_re = 0.0f;
        float sum_im = 0.0f;
        UNROLL
        for (int j = 0; j < i; ++j)
        {
            Complex term = product(lower.entry[i * ORDER + j], at_zero[j]);
            sum_re = sum_re - term.re;
            sum_im = sum_im - term.im;
        }
        at_zero[i] = make_complex(sum_re, sum_im);
        factor.gamma[i - 1] = within_unit_disc(at_zero[i]);
    }
    return factor;
}

struct HermitianMatrix { FloatPair re[ORDER * ORDER]; FloatPair im[ORDER * ORDER]; };   // entries with i >= j

/// G_ij = b_{i-j} times a power of two.
FN HermitianMatrix toeplitz_matrix(IN(BiasedMoments) biased, float power_of_two)
{
    HermitianMatrix matrix;
    UNROLL
    for (int i = 0; i < ORDER; ++i)
    {
        UNROLL
        for (int j = 0; j <= i; ++j)
        {
            int moment = 2 * max(i - j - 1, 0);
            matrix.re[i * ORDER + j] =
                i == j ? make_pair(biased.b0 * power_of_two, 0.0f) : biased_moment(biased, moment, power_of_two);
            matrix.im[i * ORDER + j] =
                i == j ? make_pair(0.0f, 0.0f) : biased_moment(biased, moment + 1, power_of_two);
        }
    }
    return matrix;
}

/// LDL^H of the Hermitian Toeplitz matrix of biased moments, normalised to b_0 = 1. Pivots come from this elimination, not
/// from h_k (1 - |gamma_k|^2), which loses the small ones.
FN Factor factor_moments(IN(BiasedMoments) biased)
{
    float unit = inverse_power_of_two(biased.b0);   // brings b_0 into [1, 2) exactly, so that no product underflows
    HermitianMatrix rest = toeplitz_matrix(biased, unit);
    LowerMatrix lower;
    Factor factor;
    factor.b0 = biased.b0;
    factor.floored = 0;
    float scale = biased.b0 * unit;
    UNROLL
    for (int k = 0; k < ORDER; ++k)
    {
        Pivot pivot = make_pivot(rest.re[k * ORDER + k], scale);
        factor.floored += pivot.floored;
        factor.inverse_h[k] = pivot.inverse_h;
        UNROLL
        for (int i = k + 1; i < ORDER; ++i)
        {
            FloatPair i_re = rest.re[i * ORDER + k];
            FloatPair i_im = rest.im[i * ORDER + k];
            lower.entry[i * ORDER + k] = make_complex(i_re.high * pivot.inverse, i_im.high * pivot.inverse);
            UNROLL
            for (int j = k + 1; j <= i; ++j)
            {
                int at = i * ORDER + j;
                FloatPair j_re = rest.re[j * ORDER + k];
                FloatPair j_im = rest.im[j * ORDER + k];
                rest.re[at] = eliminated_half(rest.re[at], pivot, i_re, j_re, i_im, j_im);
                if (i != j) rest.im[at] = eliminated_half(rest.im[at], pivot, i_im, j_re, i_re, negative_pair(j_im));
            }
        }
        scale = next_scale(scale, pivot);
    }
    return with_recurrence(factor, lower);
}
