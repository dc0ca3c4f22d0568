// reconstruction.glsl -- from moments to the absorbance in front of a depth. The steps are the same for every basis (Algorithms 1
// and 2): bias, factor, kernel polynomial, roots, weights, sum. Every step is a function that returns its result as a value.

/// Pixels that absorb less than this count as empty. Their T rounds to 1, and products of their moments could underflow.
const float MIN_ABSORBANCE = 1.0e-9f;

FN bool is_empty(IN(Moments) moments)
{
    return !(moments.b0 >= MIN_ABSORBANCE);
}

/// The moments, and what bias adds to them as separate numbers. Their sum is (1 - alpha) b + alpha b0 b*: the moments pulled
/// towards b* to compensate for rounding (supplementary, Section 1). bias: alpha, in [0, 1].
FN BiasedMoments biased_moments(IN(Moments) moments, float bias)
{
    BiasedMoments biased;
    biased.b0 = moments.b0;
    UNROLL
    for (int i = 0; i < MOMENT_FLOATS; ++i)
    {
        biased.b[i] = moments.b[i];
        PRECISE float bias_delta = bias * (moments.b0 * bias_moment(i) - moments.b[i]);
        biased.bias_delta[i] = bias_delta;
    }
    return biased;
}

/// The canonical representation at one query depth: a mass of query_weight there and a mass at a node for each root. Together they
/// have the given moments.
struct Reconstruction
{
    float t[ROOT_COUNT];         // places of the nodes: on the line 1 / (z_l - z_f), where 0 is infinitely far; on the circle
                                 // cot((phi_l - phi_f) / 2)
    float weight[ROOT_COUNT];    // their masses as shares of b0; with query_weight they sum to 1
    float value[ROOT_COUNT];     // v_l in [0, 1]: the share of a node that counts as in front
    float query_weight;          // w_0 in (0, 1]: the mass at the query depth; on the line also the gap between the bounds
    float in_front;              // sum of weight * value: the fraction of b0 in front of the query depth for beta = 0
};

#include "mass_in_front.glsl"

struct Masses { float weight[ROOT_COUNT]; };

#if ROOT_COUNT >= 3
/// If the masses do not add up to `sum`, scales the masses of the two closest nodes. If nodes nearly coincide, rounding makes their
/// masses and even their sum unreliable, while the masses of the others are right.
FN Masses restore_total_mass(IN(Masses) masses, IN(Roots) roots, float sum)
{
    PRECISE float total = 0.0f;
    UNROLL
    for (int l = 0; l < ROOT_COUNT; ++l) total = total + masses.weight[l];
    // Finds the pair (a, b) with the least (a - b)^2 / (1 + a^2 + b^2). To compare two such fractions without division, each
    // numerator is multiplied by the other denominator.
    float least = 1.0e30f;
    float of_size = 1.0f;
    float member[ROOT_COUNT];
    UNROLL
    for (int l = 0; l < ROOT_COUNT; ++l) member[l] = 0.0f;
    UNROLL
    for (int i = 1; i < ROOT_COUNT; ++i)
    {
        UNROLL
        for (int j = 0; j < i; ++j)
        {
            float a = min(max(roots.t[i], -1.0e6f), 1.0e6f);
            float b = min(max(roots.t[j], -1.0e6f), 1.0e6f);
            PRECISE float distance = (a - b) * (a - b);
            PRECISE float size = 1.0f + a * a + b * b;
            PRECISE float scaled_distance = distance * of_size;
            PRECISE float scaled_least = least * size;
            bool closer = scaled_distance < scaled_least;
            least = closer ? distance : least;
            of_size = closer ? size : of_size;
            UNROLL
            for (int l = 0; l < ROOT_COUNT; ++l) member[l] = closer ? (l == i || l == j ? 1.0f : 0.0f) : member[l];
        }
    }
    PRECISE float of_pair = 0.0f;
    UNROLL
    for (int l = 0; l < ROOT_COUNT; ++l) of_pair = of_pair + member[l] * masses.weight[l];
    PRECISE float wanted = max(of_pair + (sum - total), 0.0f);
    PRECISE float scale = of_pair > 0.0f ? wanted / of_pair : 1.0f;
    Masses result;
    UNROLL
    for (int l = 0; l < ROOT_COUNT; ++l)
        result.weight[l] = member[l] > 0.0f ? masses.weight[l] * scale : masses.weight[l];
    return result;
}
#endif

/// 1 - w_0: the mass of all nodes together. at_query: K(z_f, z_f) = 1 / w_0.
FN float mass_beside_query(float at_query)
{
    PRECISE float query_weight = 1.0f / at_query;
    return max(1.0f - query_weight, 0.0f);
}

/// The canonical representation from the roots of the kernel polynomial and their masses. in_front: the sum of mass * value.
/// mass_in_front.glsl computes it from only some of the masses.
FN Reconstruction representation(float at_query, IN(Roots) roots, IN(Masses) node_masses, float in_front, IN(Query) query,
                                 IN(Basis) basis)
{
    Reconstruction result;
    float rest = mass_beside_query(at_query);
    Masses masses = node_masses;
#if ROOT_COUNT >= 3
    masses = restore_total_mass(masses, roots, rest);
#endif
    PRECISE float weight_sum = 0.0f;
    UNROLL
    for (int l = 0; l < ROOT_COUNT; ++l)
    {
        result.t[l] = roots.t[l];
        result.weight[l] = masses.weight[l];
        result.value[l] = node_value(roots.t[l], query, basis);
        weight_sum = weight_sum + result.weight[l];
    }
    // The roots are rounded, so the masses do not sum to `rest` exactly. Scaling corrects their sum.
    PRECISE float scale = weight_sum > 0.0f ? rest / weight_sum : 0.0f;
    UNROLL
    for (int l = 0; l < ROOT_COUNT; ++l) result.weight[l] = result.weight[l] * scale;
    result.query_weight = 1.0f / at_query;
    result.in_front = in_front;
    return result;
}

/// The canonical representation from all moments. (nested_orders.glsl has one from the first four moments.)
FN Reconstruction reconstruct_with_all(IN(Query) query, IN(Factor) factor, IN(Basis) basis)
{
    Kernel kernel = kernel_polynomial(query, factor);
    Roots roots = real_roots(kernel.in_t);
    Masses masses;
    UNROLL
    for (int l = 0; l < ROOT_COUNT; ++l) masses.weight[l] = node_weight(roots.t[l], query, factor);
    float in_front = mass_in_front(roots, mass_beside_query(kernel.at_query), query, factor, basis);
    return representation(kernel.at_query, roots, masses, in_front, query, basis);
}

#ifdef NESTED_ORDERS
#include "nested_orders.glsl"
#else
/// The canonical representation at a depth in [-1, 1].
FN Reconstruction reconstruct(IN(Factor) factor, IN(Basis) basis, float depth)
{
    return reconstruct_with_all(query_at(depth, factor, basis), factor, basis);
}
#endif

/// The fraction of b0 in front of the query depth, not clamped yet. overestimation: beta in [0, 1], the share of the mass at the
/// query depth that counts as in front of it. 0 and 1 give the bounds of power and Chebyshev moments.
FN float fraction_in_front(IN(Reconstruction) reconstruction, float overestimation)
{
    PRECISE float fraction = reconstruction.in_front + overestimation * reconstruction.query_weight;
    return fraction;
}

/// x clamped to [0, 1]. NaN becomes 0, as when a GPU clamps.
FN float number_in_unit_range(float x)
{
    return x >= 0.0f ? min(x, 1.0f) : 0.0f;
}

/// A(z_f, b, beta): the absorbance in front of the query depth, in [0, b0].
FN float absorbance_in_front(IN(Reconstruction) reconstruction, float b0, float overestimation)
{
    return b0 * number_in_unit_range(fraction_in_front(reconstruction, overestimation));
}

/// The absorbance in front of a depth from the moments of a pixel, in [0, b0]: what the second pass computes for a fragment.
/// basis_parameter: the argument of make_basis.
FN float absorbance_from_moments(IN(Moments) moments, float depth, float bias, float overestimation,
                                 float basis_parameter)
{
    Basis basis = make_basis(basis_parameter);
    Factor factor = factor_moments(biased_moments(moments, bias));
    return absorbance_in_front(reconstruct(factor, basis, depth), moments.b0, overestimation);
}
