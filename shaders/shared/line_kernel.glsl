// line_kernel.glsl -- the kernel polynomial of a measure on the line about a query depth, from the recurrence of its monic
// orthogonal polynomials: what power and Chebyshev moments share.
//
// Instead of solving H q = (1, z_f, z_f^2, ...) and looking for the roots of q (Algorithm 1), everything is told by
// the monic orthogonal polynomials p_k of the measure, p_{k+1} = (z - a_k) p_k - (h_k / h_{k-1}) p_{k-1}, where
// h_k = E[p_k^2]: the same polynomial is the kernel K(z_f, z) = sum p_k(z_f) p_k(z) / h_k.

/// The query depth as the reconstruction needs it: z_f - a_k.
struct Query { float offset[ROOT_COUNT]; };

FN Query query_at(float depth, IN(Factor) factor, IN(Basis) basis)
{
    Query query;
    UNROLL
    for (int k = 0; k < ROOT_COUNT; ++k) query.offset[k] = depth - factor.a[k];
    return query;
}

/// K(z_f, z_f + s) = at_query (1 + e[0] s + ... + e[n-1] s^n); at_query = 1 / w_0 >= 1.
struct Kernel { float at_query; MonicPolynomial in_t; };

/// The kernel of the first polynomials up to a degree from 1 to ROOT_COUNT: that of the first 2 degree moments alone.
FN Kernel kernel_of_degree(IN(Query) query, IN(Factor) factor, int degree)
{
    float p[ORDER];            // p_k(z_f + s), coefficients of s^j up to the leading one, which is 1
    float previous[ORDER];     // p_{k-1}
    float sum[ORDER];
    UNROLL
    for (int j = 0; j <= ROOT_COUNT; ++j)
    {
        p[j] = 1.0f;
        previous[j] = 1.0f;
        sum[j] = j == 0 ? 1.0f : 0.0f;   // k = 0, h_0 = 1
    }
    UNROLL
    for (int k = 0; k < ROOT_COUNT; ++k)
    {
        if (k >= degree) continue;
        // From the top: coefficient j of the next one needs j and j - 1 of this one. Products with 0 are left out, which no
        // compiler may do.
        p[k + 1] = 1.0f;
        UNROLL
        for (int j = k; j >= 0; --j)
        {
            PRECISE float next = j == k ? query.offset[k] : query.offset[k] * p[j] - factor.ratio[k] * previous[j];
            if (j > 0) next = next + p[max(j - 1, 0)];
            previous[j] = p[j];
            p[j] = next;
        }
        PRECISE float scale = p[0] * factor.inverse_h[k + 1];
        UNROLL
        for (int j = 0; j <= k + 1; ++j) sum[j] = sum[j] + (j == k + 1 ? scale : scale * p[j]);
    }
    Kernel kernel;
    kernel.at_query = sum[0];
    PRECISE float inverse = 1.0f / sum[0];
    UNROLL
    for (int j = 0; j < ROOT_COUNT; ++j) kernel.in_t.e[j] = sum[j + 1] * inverse;
    return kernel;
}

FN Kernel kernel_polynomial(IN(Query) query, IN(Factor) factor)
{
    return kernel_of_degree(query, factor, ROOT_COUNT);
}

/// Weight 1 / K(z, z) of the node z = z_f + 1/t of such a kernel; 0 for t = 0, a node at infinity. Computed in t or in s,
/// whichever is below 1, so that nothing overflows.
FN float node_weight_of_degree(float t, IN(Query) query, IN(Factor) factor, int degree)
{
    PRECISE float s = 1.0f / max(abs(t), 1.0f);
    PRECISE float u = t * s;            // (s, u) is (1, t) scaled to a greatest component of at most 1
    PRECISE float u2 = u * u;
    PRECISE float previous = 1.0f;
    PRECISE float q = query.offset[0] * u + s;             // u^k p_k
    PRECISE float kernel = u2 + q * q * factor.inverse_h[1];
    PRECISE float u_power = u2;
    UNROLL
    for (int k = 1; k < ROOT_COUNT; ++k)
    {
        if (k >= degree) continue;
        PRECISE float next = (query.offset[k] * u + s) * q - factor.ratio[k] * u2 * previous;
        previous = q;
        q = next;
        kernel = kernel * u2 + q * q * factor.inverse_h[k + 1];
        u_power = u_power * u2;
    }
    return u_power / kernel;
}

FN float node_weight(float t, IN(Query) query, IN(Factor) factor)
{
    return node_weight_of_degree(t, query, factor, ROOT_COUNT);
}

/// The number of masses that mass_in_front.glsl adds up.
#define KNOWN_NODES (ROOT_COUNT / 2)

FN float node_in_front(float t, IN(Query) query)
{
    return t < 0.0f ? 1.0f : 0.0f;
}

/// v_l of Algorithm 1: 1 for a node in front of the query depth, 0 behind.
FN float node_value(float t, IN(Query) query, IN(Basis) basis)
{
    return node_in_front(t, query);
}

/// The mass in front of the query depth if there are two nodes: with the query they have the sum 1 and the mean a_0.
/// rest: the mass of both nodes.
FN float mass_in_front_of_two(float t1, float t2, float rest, IN(Query) query)
{
    float front = min(t1, t2);
    float behind = max(t1, t2);
    PRECISE float lone = front * (query.offset[0] * behind + rest) / (front - behind);
    float mixed = clamp(lone, 0.0f, rest);   // where one is in front and one behind
    return front < 0.0f ? (behind < 0.0f ? rest : mixed) : 0.0f;
}
