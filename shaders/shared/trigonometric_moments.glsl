// trigonometric_moments.glsl -- trigonometric moments of the absorbance (paper, Section 5): generation, bias, and the kernel
// polynomial about a query depth. MOMENT_COUNT m is 2, 3 or 4.
//
// Depths lie on the unit circle: x(z) = exp(i phi) with phi = (z + 1)(pi - theta/2) (paper, Eq. 5). The polynomial of Algorithm 2
// is the kernel of the monic Szego polynomials. On the circle these obey p_{k+1}(x) = x p_k(x) + gamma_k x^k conj(p_k(x)).
//
// The circle is turned so that the query is at x = 1. With t = cot((phi - phi_f)/2), x = (t + i)/(t - i). Let q_k(t) = (t - i)^k
// p_k and multiply the recurrence by (t - i)^(k+1). Since x (t - i) = t + i and conj(t - i) = t + i, the result is
// q_{k+1} = y + gamma_k conj(y) with y = (t + i) q_k. So all arithmetic is real, on the real and imaginary parts of coefficients.

#define ALGORITHM_2   // see textbook.glsl
#define ROOT_COUNT MOMENT_COUNT
#define MOMENT_FLOATS (2 * MOMENT_COUNT)
#define ORDER (MOMENT_COUNT + 1)   // number of rows of the Toeplitz matrix
#include "moments.glsl"
#include "complex.glsl"
#include "depth_circle.glsl"
#include "float_pair.glsl"
#include "elimination.glsl"
#include "toeplitz_factor.glsl"
#include "real_roots.glsl"

/// b* = 0: bias pulls towards the uniform distribution on the circle, whose moments are 0 except for the zeroth (supplementary,
/// Table 1).
FN float bias_moment(int i)
{
    return 0.0f;
}

/// Moments of one fragment: absorbance * (1, x, ..., x^m). depth in [-1, 1].
FN Moments fragment_moments(float depth, float absorbance, IN(Basis) basis)
{
    Moments moments;
    moments.b0 = absorbance;
    Complex half_x = half_phase(depth, basis);
    Complex x = on_unit_circle(product(half_x, half_x));
    Complex power = x;
    UNROLL
    for (int i = 0; i < MOMENT_COUNT; ++i)
    {
        moments.b[2 * i] = absorbance * power.re;
        moments.b[2 * i + 1] = absorbance * power.im;
        power = on_unit_circle(product(power, x));
    }
    return moments;
}

/// The query depth in the form that the reconstruction needs: half its phase, and gamma_k on the circle that is turned so that the
/// query is at x = 1.
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

/// Coefficients of t^j while the kernel is computed: those of q_k, and those of the sum of conj(p_k(1)) / h_k q_k (t - i)^(m-k) so
/// far.
struct KernelTerms { float re[ORDER]; float im[ORDER]; float sum_re[ORDER]; float sum_im[ORDER]; };

/// The next terms: q_{k+1} = y + gamma conj(y) with y = (t + i) q_k, and the sum times (t - i).
FN KernelTerms next_terms(IN(KernelTerms) terms, IN(Complex) gamma)
{
    KernelTerms next;
    PRECISE float plus = 1.0f + gamma.re;
    PRECISE float minus = 1.0f - gamma.re;
    UNROLL
    for (int j = 0; j < ORDER; ++j)
    {
        int below = max(j - 1, 0);   // multiplication by t moves coefficients up
        PRECISE float y_re = (j == 0 ? 0.0f : terms.re[below]) - terms.im[j];
        PRECISE float y_im = (j == 0 ? 0.0f : terms.im[below]) + terms.re[j];
        PRECISE float sum_re = (j == 0 ? 0.0f : terms.sum_re[below]) + terms.sum_im[j];
        PRECISE float sum_im = (j == 0 ? 0.0f : terms.sum_im[below]) - terms.sum_re[j];
        PRECISE float re = plus * y_re + gamma.im * y_im;
        PRECISE float im = gamma.im * y_re + minus * y_im;
        next.re[j] = re;
        next.im[j] = im;
        next.sum_re[j] = sum_re;
        next.sum_im[j] = sum_im;
    }
    return next;
}

/// The kernel with the query at x = 1: (t - i)^m K(1, x(t)) = at_query (t^m + e[0] t^(m-1) + ...). It is real for real t.
/// at_query = K(1, 1) = 1 / w_0 >= 1.
struct Kernel { float at_query; MonicPolynomial in_t; };

FN Kernel kernel_polynomial(IN(Query) query, IN(Factor) factor)
{
    KernelTerms terms;
    UNROLL
    for (int j = 0; j < ORDER; ++j)
    {
        terms.re[j] = j == 0 ? 1.0f : 0.0f;
        terms.im[j] = 0.0f;
        terms.sum_re[j] = terms.re[j];
        terms.sum_im[j] = 0.0f;
    }
    // The leading coefficient, computed as a sum of squares. As a sum of leading coefficients it would cancel.
    PRECISE float at_query = 1.0f;
    UNROLL
    for (int k = 0; k < MOMENT_COUNT; ++k)
    {
        terms = next_terms(terms, query.gamma[k]);
        PRECISE float scale_re = terms.re[k + 1] * factor.inverse_h[k + 1];
        PRECISE float scale_im = terms.im[k + 1] * factor.inverse_h[k + 1];
        at_query = at_query + (terms.re[k + 1] * scale_re + terms.im[k + 1] * scale_im);
        UNROLL
        for (int j = 0; j < ORDER; ++j)
        {
            PRECISE float sum_re = terms.sum_re[j] + (scale_re * terms.re[j] + scale_im * terms.im[j]);
            PRECISE float sum_im = terms.sum_im[j] + (scale_re * terms.im[j] - scale_im * terms.re[j]);
            terms.sum_re[j] = sum_re;
            terms.sum_im[j] = sum_im;
        }
    }
    Kernel kernel;
    kernel.at_query = at_query;
    PRECISE float inverse = 1.0f / at_query;
    UNROLL
    for (int j = 0; j < MOMENT_COUNT; ++j) kernel.in_t.e[j] = terms.sum_re[MOMENT_COUNT - 1 - j] * inverse;
    return kernel;
}

/// The weight 1 / K(x, x) of the node x(t). t + i is scaled so that nothing overflows.
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

/// The number of nodes whose masses mass_in_front.glsl adds up. The wrapping zone holds no depths. So at most one node in it is
/// heavier than the mass that bias puts there, and one mass can always be left out.
#define KNOWN_NODES (ROOT_COUNT - 1)

/// 1 for a node in front of the query depth, that is t < -cot(phi_f / 2), otherwise 0.
FN float node_in_front(float t, IN(Query) query)
{
    PRECISE float gap = t * query.half_phase.im + query.half_phase.re;
    return gap < 0.0f ? 1.0f : 0.0f;
}

/// 1 for a node behind the query depth, that is t > -cot((phi_f + theta) / 2), otherwise 0. A node that is neither in front nor
/// behind lies in the wrapping zone.
FN float node_behind(float t, IN(Query) query, IN(Basis) basis)
{
    PRECISE float end_sine = query.half_phase.im * basis.quarter_cosine + query.half_phase.re * basis.quarter_sine;
    PRECISE float end_cosine = query.half_phase.re * basis.quarter_cosine - query.half_phase.im * basis.quarter_sine;
    PRECISE float gap = t * end_sine + end_cosine;
    return gap > 0.0f ? 1.0f - node_in_front(t, query) : 0.0f;
}

/// v_l of Eq. 6: 1 for a node in front of the query depth, 0 for a node behind it, and a ramp in the wrapping zone.
FN float node_value(float t, IN(Query) query, IN(Basis) basis)
{
    PRECISE float s = 1.0f / max(abs(t), 1.0f);
    Complex half_turn = make_complex(t * s, s);       // exp(i (phi - phi_f)/2), scaled
    Complex half_x = product(query.half_phase, half_turn);
    PRECISE float inverse_length2 = 1.0f / (half_turn.re * half_turn.re + half_turn.im * half_turn.im);
    Complex x = product(half_x, half_x);
    PRECISE float order = phase_order(make_complex(x.re * inverse_length2, x.im * inverse_length2));
    float ramp = clamp(order * basis.ramp_scale + basis.ramp_offset, 0.0f, 1.0f);
    // The zone ends at depth -1, where the phase is 2 pi. Rounding may take a node there slightly further. Then phase_order, which
    // is at least 3 within the zone, begins again at -1.
    ramp = order < 1.0f ? 1.0f : ramp;
    float in_zone = (1.0f - node_in_front(t, query)) * (1.0f - node_behind(t, query, basis));
    return node_in_front(t, query) + in_zone * ramp;
}
