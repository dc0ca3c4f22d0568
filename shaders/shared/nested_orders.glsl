// nested_orders.glsl -- reconstructs each fragment from as few moments as it needs: from the first four if these are as certain as
// all eight, within a tolerance.
//
// The recurrence of the orthogonal polynomials is nested: its first two steps are the factor of the first four moments. So the mass
// w_0 at the query depth is known for both orders before any root is computed. With eight moments it is at least the absorbance of
// the fragment itself, as a share of b_0. With four moments it is larger, and the difference says how much less certain four
// moments are.

/// w_0 = 1 / K(z_f, z_f) for four and for eight moments.
struct QueryWeights { float of_4; float of_8; };

FN QueryWeights query_weights(IN(Query) query, IN(Factor) factor)
{
    QueryWeights weights;
    PRECISE float previous = 0.0f;
    PRECISE float p = 1.0f;
    PRECISE float kernel = 1.0f;
    UNROLL
    for (int k = 0; k < ROOT_COUNT; ++k)
    {
        PRECISE float next = query.offset[k] * p - factor.ratio[k] * previous;
        previous = p;
        p = next;
        kernel = kernel + p * p * factor.inverse_h[k + 1];
        if (k == 1) weights.of_4 = 1.0f / kernel;
    }
    weights.of_8 = 1.0f / kernel;
    return weights;
}

/// The share of eight moments in the result. Up to the tolerance, four moments alone count; beyond twice the tolerance, eight
/// alone. Between them both are mixed, so the picture is continuous and nothing pops. Uncertainty is measured in T. T is greatest,
/// and falls fastest, where the absorbance in front is least: at the lower bound that four moments give.
FN float share_of_8(IN(QueryWeights) weights, float lower_bound_of_4, float b0, float tolerance)
{
    PRECISE float wider = b0 * max(weights.of_4 - weights.of_8, 0.0f);
    PRECISE float of_transmittance =
        portable_exp(-b0 * clamp(lower_bound_of_4, 0.0f, 1.0f)) * (1.0f - portable_exp(-wider));
    PRECISE float x = clamp(of_transmittance / tolerance - 1.0f, 0.0f, 1.0f);
    PRECISE float share = x * x * (3.0f - 2.0f * x);
    return share;
}

/// The canonical representation from the first four moments alone.
FN Reconstruction reconstruct_with_4(IN(Query) query, IN(Factor) factor, IN(Basis) basis)
{
    Kernel kernel = kernel_of_degree(query, factor, 2);
    RootPair pair = quadratic_roots(kernel.in_t.e[0], kernel.in_t.e[1]);
    Roots roots;
    Masses masses;
    UNROLL
    for (int l = 0; l < ROOT_COUNT; ++l)   // nodes beyond the second are infinitely far away and have weight 0
    {
        roots.t[l] = l == 0 ? pair.first : (l == 1 ? pair.second : 0.0f);
        masses.weight[l] = l < 2 ? node_weight_of_degree(roots.t[l], query, factor, 2) : 0.0f;
    }
    float in_front = mass_in_front_of_two(pair.first, pair.second, mass_beside_query(kernel.at_query), query);
    return representation(kernel.at_query, roots, masses, in_front, query, basis);
}

/// depth in [-1, 1]. If both orders are mixed, the nodes are those of eight moments. Their masses are scaled to what the mixed mass
/// at the query depth leaves.
FN Reconstruction reconstruct(IN(Factor) factor, IN(Basis) basis, float depth)
{
    Query query = query_at(depth, factor, basis);
    Reconstruction of_4 = reconstruct_with_4(query, factor, basis);
    float share = share_of_8(query_weights(query, factor), of_4.in_front, factor.b0, basis.tolerance);
    if (share <= 0.0f) return of_4;
    Reconstruction result = reconstruct_with_all(query, factor, basis);
    PRECISE float in_front = of_4.in_front + share * (result.in_front - of_4.in_front);
    PRECISE float query_weight = of_4.query_weight + share * (result.query_weight - of_4.query_weight);
    PRECISE float scale = (1.0f - query_weight) / max(1.0f - result.query_weight, 1.0e-6f);
    UNROLL
    for (int l = 0; l < ROOT_COUNT; ++l) result.weight[l] = result.weight[l] * scale;
    result.in_front = in_front;
    result.query_weight = query_weight;
    return result;
}
