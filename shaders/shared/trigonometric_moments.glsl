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
#include "moments.glsl"
#include "complex.glsl"
#include "depth_circle.glsl"
#include "float_pair.glsl"
#include "toeplitz_factor.glsl"
#include "real_roots.glsl"

/// Bias pulls towards the uniform distribution on the circle, whose other moments are 0 (supplementary, Table 1).
FN float bias_moment(int i)
{
    return 0.0f;
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
