// line_interval.glsl -- the sharp bounds on the line if all mass lies in [-1, 1]. The moments are then those of the pixel's own
// interval (ends.glsl).
//
// The canonical representation at the query s has n other nodes, the roots of the kernel K(s, z). If they all lie in [-1, 1], it is
// the sharp one (Markov; Krein and Nudelman 1977, Chapter III). Otherwise the sharp one has both ends as nodes, s, and n - 1 nodes
// between. Take the inner measure (1 - z^2) dmu: the ends have no mass there, so s and the n - 1 nodes are its canonical
// representation. Its moments up to m - 2 follow from those of mu. Masses: if v is one of the inner measure at z, v / (1 - z^2) is
// that of mu. The mass of the near end follows from the total mass and from the mean.

/// The factor of the inner measure, normalised to b_0 = 1 of mu; only the first ROOT_COUNT - 1 of a, and ROOT_COUNT of inverse_h.
FN Factor factor_inner(IN(BiasedMoments) biased)
{
    return factor_matrix(biased, true);
}

/// What a pixel stores of the factor of the inner measure: a_k, then 1 / h_k.
#define INNER_FLOATS (2 * ROOT_COUNT - 1)
struct StoredInner { float x[INNER_FLOATS]; };

FN StoredInner packed_inner(IN(Factor) inner)
{
    StoredInner stored;
    UNROLL
    for (int k = 0; k < ROOT_COUNT; ++k)
    {
        if (k < ROOT_COUNT - 1) stored.x[k] = inner.a[k];
        stored.x[ROOT_COUNT - 1 + k] = inner.inverse_h[k];
    }
    return stored;
}

FN Factor unpacked_inner(IN(StoredInner) stored)
{
    Factor inner;
    inner.b0 = 1.0f;
    inner.floored = 0;
    UNROLL
    for (int k = 0; k < ROOT_COUNT; ++k)
    {
        inner.a[k] = k < ROOT_COUNT - 1 ? stored.x[min(k, ROOT_COUNT - 2)] : 0.0f;
        inner.inverse_h[k] = stored.x[ROOT_COUNT - 1 + k];
    }
    inner.inverse_h[ROOT_COUNT] = 0.0f;   // not used
    return with_ratios_up_to(inner, ROOT_COUNT - 1);
}

/// True if no root of the kernel lies outside of [-1, 1]. At most one lies beyond each end, because the roots and s interlace with
/// the roots of p_n, which lie inside. So the signs at the ends tell, compared with those far outside.
FN bool all_nodes_inside(IN(Kernel) kernel, float depth)
{
    PRECISE float up = 1.0f - depth;
    PRECISE float down = -1.0f - depth;
    PRECISE float at_far = kernel.in_t.e[ROOT_COUNT - 1];
    PRECISE float at_near = kernel.in_t.e[ROOT_COUNT - 1];
    UNROLL
    for (int j = ROOT_COUNT - 2; j >= 0; --j)
    {
        at_far = at_far * up + kernel.in_t.e[j];
        at_near = at_near * down + kernel.in_t.e[j];
    }
    at_far = at_far * up + 1.0f;
    at_near = at_near * down + 1.0f;
    float outside = kernel.in_t.e[ROOT_COUNT - 1];
    float parity = ROOT_COUNT == 3 ? -1.0f : 1.0f;
    return (at_far >= 0.0f) == (outside >= 0.0f) && (at_near >= 0.0f) == (parity * outside >= 0.0f);
}

/// The roots of the kernel of the inner measure, which has ROOT_COUNT - 1 of them.
FN Roots inner_roots(IN(MonicPolynomial) p)
{
    Roots roots;
    roots.t[ROOT_COUNT - 1] = 0.0f;
#if ROOT_COUNT == 2
    roots.t[0] = -p.e[0];
#elif ROOT_COUNT == 3
    RootPair pair = quadratic_roots(p.e[0], p.e[1]);
    roots.t[0] = pair.first;
    roots.t[1] = pair.second;
#else
    RootTriple triple = cubic_roots(p.e[0], p.e[1], p.e[2]);
    roots.t[0] = triple.first;
    roots.t[1] = triple.second;
    roots.t[2] = triple.third;
#endif
    return roots;
}

/// The masses of the inner measure at the roots of its kernel. at_query: its mass at the query.
FN Masses inner_masses(IN(Roots) roots, float at_query, IN(Query) query, IN(Factor) inner)
{
    Masses masses;
    UNROLL
    for (int l = 0; l < ROOT_COUNT; ++l)
        masses.weight[l] = l < ROOT_COUNT - 1 ? node_weight_of_degree(roots.t[l], query, inner, ROOT_COUNT - 1) : 0.0f;
#if ROOT_COUNT >= 3
    Roots padded = roots;
    padded.t[ROOT_COUNT - 1] = 1.0e6f;   // no node; far from all others
    PRECISE float rest = 1.0f / inner.inverse_h[0] - at_query;
    masses = restore_total_mass(masses, padded, max(rest, 0.0f));
#endif
    return masses;
}

/// A canonical representation that has both ends as nodes.
struct EndRepresentation
{
    float t[ROOT_COUNT];        // places of the ROOT_COUNT - 1 inner nodes, 1 / (z - s)
    float weight[ROOT_COUNT];   // their masses as shares of b_0
    float near;                 // the masses of the ends
    float far;
    float query_weight;
    float in_front;             // the near end and the inner nodes in front of s
};

const float LEAST_TO_END = 1.0e-12f;   // no distance to an end is smaller; a mass there is 0 or nearly so

FN EndRepresentation representation_with_ends(IN(Factor) inner, IN(Basis) basis, float mean, float depth)
{
    Query query = query_at(depth, inner, basis);
    Kernel kernel = kernel_of_degree(query, inner, ROOT_COUNT - 1);
    Roots roots = inner_roots(kernel.in_t);
    EndRepresentation result;
    PRECISE float to_near = max(1.0f + depth, LEAST_TO_END);
    PRECISE float to_far = max(1.0f - depth, LEAST_TO_END);
    PRECISE float at_query = 1.0f / kernel.at_query;
    PRECISE float query_weight = min(at_query / (to_near * to_far), 1.0f);
    // The mass of the near end is half of the sum of w (1 - z) over all nodes, which is 1 - mean, less that of the other nodes. With
    // the nodes in front of s added, a node that nearly coincides with an end divides by nothing small.
    Masses masses = inner_masses(roots, at_query, query, inner);
    PRECISE float twice_in_front = 1.0f - mean - at_query / to_near;
    PRECISE float between_front = 0.0f;
    PRECISE float between_behind = 0.0f;
    UNROLL
    for (int l = 0; l < ROOT_COUNT; ++l)
    {
        result.t[l] = roots.t[l];
        result.weight[l] = 0.0f;
        if (l == ROOT_COUNT - 1) continue;
        PRECISE float z = clamp(depth + 1.0f / roots.t[l], -1.0f, 1.0f);
        PRECISE float node_to_near = max(1.0f + z, LEAST_TO_END);
        PRECISE float node_to_far = max(1.0f - z, LEAST_TO_END);
        float mass = masses.weight[l];
        bool front = roots.t[l] < 0.0f;
        twice_in_front = twice_in_front + (front ? mass / node_to_far : -(mass / node_to_near));
        result.weight[l] = min(mass / (node_to_near * node_to_far), 1.0f);
        between_front = between_front + (front ? result.weight[l] : 0.0f);
        between_behind = between_behind + (front ? 0.0f : result.weight[l]);
    }
    float in_front = number_in_unit_range(0.5f * twice_in_front);
    result.near = max(in_front - between_front, 0.0f);
    result.far = max(1.0f - in_front - query_weight - between_behind, 0.0f);
    result.query_weight = query_weight;
    result.in_front = in_front;
    return result;
}

/// The sharp bounds at a depth in [-1, 1] of the pixel's own interval.
FN QueryMasses sharp_masses(IN(Factor) factor, IN(Factor) inner, IN(Basis) basis, float depth)
{
    Query query = query_at(depth, factor, basis);
    Kernel kernel = kernel_polynomial(query, factor);
    if (all_nodes_inside(kernel, depth))
    {
        PRECISE float at_query = 1.0f / kernel.at_query;
        return make_masses(mass_in_front(real_roots(kernel.in_t), mass_beside_query(kernel.at_query), query, factor, basis),
                           at_query);
    }
    EndRepresentation with_ends = representation_with_ends(inner, basis, factor.a[0], depth);
    return make_masses(with_ends.in_front, with_ends.query_weight);
}
