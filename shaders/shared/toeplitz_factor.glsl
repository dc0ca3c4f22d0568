// toeplitz_factor.glsl -- factors the Toeplitz matrix of trigonometric moments.
//
// There is no PRECISE here. glslangValidator takes forever to follow it through these arrays, and every sum that a compiler could
// re-associate is in a function that has it.

struct Factor
{
    float b0;
    Complex gamma[MOMENT_COUNT];   // Verblunsky coefficients, those of the Szego recurrence
    float inverse_h[ORDER];        // 1 / h_k; h_k = E[|p_k|^2] is a pivot
    int floored;                   // number of pivots that were raised to the floor
};

/// What a pixel stores of its factor, so that the second pass need not factor again: gamma_k, then 1 / h_k for k > 0. h_0 is always
/// 1.
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

/// b0: the total absorbance, which is stored separately.
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

struct LowerMatrix { Complex entry[ORDER * ORDER]; };   // L: (i, j) at i ORDER + j for i > j; its diagonal is 1

/// x; if it lies outside of the unit circle, it is moved onto the circle. Verblunsky coefficients of a distribution never lie
/// outside. After rounding, moments may belong to no distribution; then larger coefficients would let the polynomials overflow.
FN Complex within_unit_disc(IN(Complex) x)
{
    PRECISE float length2 = x.re * x.re + x.im * x.im;
    PRECISE float inverse_length = 1.0f / sqrt(max(length2, 1.0f));
    return make_complex(x.re * inverse_length, x.im * inverse_length);
}

/// The Verblunsky coefficients gamma_k = p_{k+1}(0).
///
/// From G = L D L^H with G_ij = E[x^i conj(x^j)] follows x^i = sum of L_ij p_j(x). At x = 0 this is 0 for i > 0, and the diagonal
/// of L is 1. So p_i(0) = -(sum over j < i of L_ij p_j(0)), beginning with p_0(0) = 1.
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

struct HermitianMatrix { FloatPair re[ORDER * ORDER]; FloatPair im[ORDER * ORDER]; };   // (i, j) at i ORDER + j for i >= j

/// The matrix G_ij = b_{i-j} of biased moments, times a power of two.
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
            matrix.re[i * ORDER + j] = choose_pair(i == j, make_pair(biased.b0 * power_of_two, 0.0f),
                                                   biased_moment(biased, moment, power_of_two));
            matrix.im[i * ORDER + j] =
                choose_pair(i == j, make_pair(0.0f, 0.0f), biased_moment(biased, moment + 1, power_of_two));
        }
    }
    return matrix;
}

/// Factors the Hermitian Toeplitz matrix of biased moments, normalised to b_0 = 1, into L D L^H. The pivots h_k come from this
/// elimination. The recurrence h_{k+1} = h_k (1 - |gamma_k|^2) would lose the digits of small ones.
FN Factor factor_moments(IN(BiasedMoments) biased)
{
    float unit = inverse_power_of_two(biased.b0);   // brings b_0 into [1, 2) without rounding, so no product underflows
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
