// trigonometric_moments.glsl -- trigonometric moments of the absorbance (Section 5): generation, bias,
// factorisation, and the kernel polynomial about a query depth. MOMENT_COUNT m is 2, 3 or 4.
//
// Depths lie on the unit circle, x(z) = exp(i phi), phi = (z + 1)(pi - theta/2) (Eq. 5). Algorithm 2's polynomial is the
// kernel of the monic Szego polynomials, p_{k+1}(x) = x p_k(x) + gamma_k x^k conj(p_k(x)) on the circle. In the frame
// turned so that the query is x = 1, with t = cot((phi - phi_f)/2), x = (t + i)/(t - i), the polynomials
// q_k(t) = (t - i)^k p_k obey q_{k+1} = y + gamma_k conj(y) with y = (t + i) q_k: real arithmetic throughout.

#define ROOT_COUNT MOMENT_COUNT
#define MOMENT_FLOATS (2 * MOMENT_COUNT)
#define ORDER (MOMENT_COUNT + 1)   // of the Toeplitz matrix
#include "float_pair.glsl"
#include "real_roots.glsl"

/// A pivot below this is rounding noise (1 ulp of a normalised moment) and counts as this.
const float PIVOT_FLOOR = 6.0e-8f;

/// Bias pulls towards the uniform distribution on the circle, whose other moments are 0 (supplementary, Table 1).
FN float bias_moment(int i)
{
    return 0.0f;
}

/// The zeroth moment b0 (total absorbance, >= 0), then Re b_1, Im b_1, Re b_2, ..., not normalised.
struct Moments { float b0; float b[MOMENT_FLOATS]; };

/// Moments with what bias adds to them, kept apart: b[i] + pull[i], not normalised. Added up they would lose most digits
/// of a small pull, which is all that keeps the matrix of a few fragments regular.
struct BiasedMoments { float b0; float b[MOMENT_FLOATS]; float pull[MOMENT_FLOATS]; };

struct Complex { float re; float im; };

FN Complex make_complex(float re, float im)
{
    Complex result;
    result.re = re;
    result.im = im;
    return result;
}

FN Complex product(IN(Complex) a, IN(Complex) b)
{
    PRECISE float re = a.re * b.re - a.im * b.im;
    PRECISE float im = a.re * b.im + a.im * b.re;
    return make_complex(re, im);
}

FN Complex conjugate(IN(Complex) a)
{
    Complex result;
    result.re = a.re;
    result.im = -a.im;
    return result;
}

/// psi of Section 5.2: grows with the phase like an angle, from -1 at phase -pi/4 to 7; no inverse trigonometry.
FN float phase_order(IN(Complex) x)
{
    PRECISE float r = abs(x.im) - abs(x.re);
    r = x.re < 0.0f ? 2.0f - r : r;
    return x.im < 0.0f ? 6.0f - r : r;
}

/// What depends on theta but not on depth.
struct Basis
{
    float half_phase_scale;     // phi / 2 per (z + 1)
    float quarter_sine;         // of theta / 2: from the end of the depth range to the end of the circle
    float quarter_cosine;
    float ramp_scale;           // v of a node in the wrapping zone is ramp_scale psi + ramp_offset (Eq. 6)
    float ramp_offset;
};

/// wrapping_zone_angle theta in [0, pi].
FN Basis make_basis(float wrapping_zone_angle)
{
    Basis basis;
    basis.half_phase_scale = 0.5f * PI - 0.25f * wrapping_zone_angle;
    SinCos half_zone = portable_sincos(0.5f * wrapping_zone_angle);
    basis.quarter_sine = half_zone.sine;
    basis.quarter_cosine = half_zone.cosine;
    Complex end = make_complex(half_zone.cosine, -half_zone.sine);   // half of the phase 2 pi - theta, squared below
    float zone_start = phase_order(product(end, end));
    PRECISE float ramp = 1.0f / (7.0f - zone_start);
    basis.ramp_scale = wrapping_zone_angle > 0.0f ? ramp : 0.0f;
    basis.ramp_offset = wrapping_zone_angle > 0.0f ? 1.0f - 7.0f * ramp : 0.0f;
    return basis;
}

/// exp(i phi / 2) of a depth in [-1, 1].
FN Complex half_phase(float depth, IN(Basis) basis)
{
    SinCos half_angle = portable_sincos((depth + 1.0f) * basis.half_phase_scale);
    return make_complex(half_angle.cosine, half_angle.sine);
}

/// Moments of one fragment, absorbance * (1, x, ..., x^m).
FN Moments fragment_moments(float depth, float absorbance, IN(Basis) basis)
{
    Moments moments;
    moments.b0 = absorbance;
    Complex half_x = half_phase(depth, basis);
    Complex x = product(half_x, half_x);
    Complex power = make_complex(absorbance, 0.0f);
    UNROLL
    for (int i = 0; i < MOMENT_COUNT; ++i)
    {
        power = product(power, x);
        moments.b[2 * i] = power.re;
        moments.b[2 * i + 1] = power.im;
    }
    return moments;
}

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

/// The query depth as the reconstruction needs it: half its phase, and gamma_k in the frame where it is x = 1.
struct Query { Complex half_phase; Complex gamma[MOMENT_COUNT]; };

FN Query query_at(float depth, IN(Factor) factor, IN(Basis) basis)
{
    Query query;
    query.half_phase = half_phase(depth, basis);
    Complex back = conjugate(product(query.half_phase, query.half_phase));
    Complex turn = back;
    UNROLL
    for (int k = 0; k < MOMENT_COUNT; ++k)
    {
        query.gamma[k] = product(factor.gamma[k], turn);
        turn = product(turn, back);
    }
    return query;
}

/// (t - i)^m K(1, x(t)) = at_query (t^m + e[0] t^(m-1) + ...), real for real t; at_query = 1 / w_0 >= 1.
struct Kernel { float at_query; MonicPolynomial in_t; };

FN Kernel kernel_polynomial(IN(Query) query, IN(Factor) factor)
{
    float re[ORDER];       // q_k, coefficients of t^j
    float im[ORDER];
    float sum_re[ORDER];   // sum of conj(p_k(1)) / h_k q_k (t - i)^(m-k), by Horner's rule
    float sum_im[ORDER];
    UNROLL
    for (int j = 0; j <= MOMENT_COUNT; ++j)
    {
        re[j] = j == 0 ? 1.0f : 0.0f;
        im[j] = 0.0f;
        sum_re[j] = re[j];
        sum_im[j] = 0.0f;
    }
    // The leading coefficient is a sum of squares. As the sum of leading coefficients it would cancel.
    PRECISE float at_query = 1.0f;
    UNROLL
    for (int k = 0; k < MOMENT_COUNT; ++k)
    {
        PRECISE float plus = 1.0f + query.gamma[k].re;
        PRECISE float minus = 1.0f - query.gamma[k].re;
        PRECISE float cross = query.gamma[k].im;
        PRECISE float carried_re = 0.0f;
        PRECISE float carried_im = 0.0f;
        PRECISE float carried_sum_re = 0.0f;
        PRECISE float carried_sum_im = 0.0f;
        UNROLL
        for (int j = 0; j <= MOMENT_COUNT; ++j)
        {
            PRECISE float y_re = carried_re - im[j];             // y = (t + i) q
            PRECISE float y_im = carried_im + re[j];
            PRECISE float s_re = carried_sum_re + sum_im[j];     // sum (t - i)
            PRECISE float s_im = carried_sum_im - sum_re[j];
            carried_re = re[j];
            carried_im = im[j];
            carried_sum_re = sum_re[j];
            carried_sum_im = sum_im[j];
            re[j] = plus * y_re + cross * y_im;
            im[j] = cross * y_re + minus * y_im;
            sum_re[j] = s_re;
            sum_im[j] = s_im;
        }
        PRECISE float scale_re = re[k + 1] * factor.inverse_h[k + 1];
        PRECISE float scale_im = im[k + 1] * factor.inverse_h[k + 1];
        at_query = at_query + (re[k + 1] * scale_re + im[k + 1] * scale_im);
        UNROLL
        for (int j = 0; j <= MOMENT_COUNT; ++j)
        {
            sum_re[j] = sum_re[j] + (scale_re * re[j] + scale_im * im[j]);
            sum_im[j] = sum_im[j] + (scale_re * im[j] - scale_im * re[j]);
        }
    }
    Kernel kernel;
    kernel.at_query = at_query;
    PRECISE float inverse = 1.0f / at_query;
    UNROLL
    for (int j = 0; j < MOMENT_COUNT; ++j) kernel.in_t.e[j] = sum_re[MOMENT_COUNT - 1 - j] * inverse;
    return kernel;
}

/// Weight 1 / K(x, x) of the node x(t). (t + i) is scaled to length 1, so that nothing overflows.
FN float node_weight(float t, IN(Query) query, IN(Factor) factor)
{
    PRECISE float s = 1.0f / max(abs(t), 1.0f);
    PRECISE float u = t * s;
    PRECISE float length2 = u * u + s * s;
    PRECISE float re = 1.0f;
    PRECISE float im = 0.0f;
    PRECISE float kernel = 1.0f;
    PRECISE float power = 1.0f;
    UNROLL
    for (int k = 0; k < MOMENT_COUNT; ++k)
    {
        PRECISE float y_re = u * re - s * im;
        PRECISE float y_im = u * im + s * re;
        re = (1.0f + query.gamma[k].re) * y_re + query.gamma[k].im * y_im;
        im = query.gamma[k].im * y_re + (1.0f - query.gamma[k].re) * y_im;
        kernel = kernel * length2 + (re * re + im * im) * factor.inverse_h[k + 1];
        power = power * length2;
    }
    return power / kernel;
}

/// v of Eq. 6: 1 for a node in front of the query depth, 0 behind, and a ramp in the wrapping zone. Two thresholds of
/// t tell which: t < -cot(phi_f / 2) in front, t > -cot((phi_f + theta) / 2) behind.
FN float node_value(float t, IN(Query) query, IN(Basis) basis)
{
    PRECISE float front_gap = t * query.half_phase.im + query.half_phase.re;
    PRECISE float end_sine = query.half_phase.im * basis.quarter_cosine + query.half_phase.re * basis.quarter_sine;
    PRECISE float end_cosine = query.half_phase.re * basis.quarter_cosine - query.half_phase.im * basis.quarter_sine;
    PRECISE float zone_gap = t * end_sine + end_cosine;
    PRECISE float s = 1.0f / max(abs(t), 1.0f);
    Complex half_turn = make_complex(t * s, s);       // exp(i (phi - phi_f)/2), scaled
    Complex half_x = product(query.half_phase, half_turn);
    PRECISE float length2 = half_turn.re * half_turn.re + half_turn.im * half_turn.im;
    Complex x = product(half_x, half_x);
    PRECISE float order = phase_order(make_complex(x.re / length2, x.im / length2));
    float ramp = clamp(order * basis.ramp_scale + basis.ramp_offset, 0.0f, 1.0f);
    return front_gap < 0.0f ? 1.0f : (zone_gap > 0.0f ? 0.0f : ramp);
}
