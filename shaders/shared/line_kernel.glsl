// line_kernel.glsl -- the kernel polynomial of moments on the line, expanded about the query depth z_f. Power and Chebyshev moments
// share it.
//
// Algorithm 1 solves H q = (1, z_f, z_f^2, ...) and looks for the roots of the polynomial with the coefficients q. With H = L D L^T
// this polynomial is sum of p_k(z_f) p_k(z) / h_k, because L^-1 (1, z, z^2, ...) = (p_0(z), p_1(z), ...). It is called the kernel
// K(z_f, z) here. The p_k are the monic orthogonal polynomials and h_k = E[p_k^2]. They obey
// p_{k+1} = (z - a_k) p_k - (h_k / h_{k-1}) p_{k-1}, so neither q nor H is needed.

/// The query depth in the form that the reconstruction needs: z_f - a_k.
struct Query { float offset[ROOT_COUNT]; };

FN Query query_at(float depth, IN(Factor) factor, IN(Basis) basis)
{
    Query query;
    UNROLL
    for (int k = 0; k < ROOT_COUNT; ++k) query.offset[k] = depth - factor.a[k];
    return query;
}

/// K(z_f, z_f + s) = at_query (1 + e[0] s + ... + e[n-1] s^n), where at_query = K(z_f, z_f) = 1 / w_0. With t = 1/s, the roots
/// of the bracket are those of the monic polynomial in_t, t^n + e[0] t^(n-1) + ... + e[n-1].
struct Kernel { float at_query; MonicPolynomial in_t; };

/// The kernel of p_0 to p_degree, which belongs to the first 2 degree moments alone. degree in 1..ROOT_COUNT.
FN Kernel kernel_of_degree(IN(Query) query, IN(Factor) factor, int degree)
{
    float p[ORDER];            // coefficients of p_k(z_f + s) in s^j; the leading one is 1
    float previous[ORDER];     // p_{k-1}
    float sum[ORDER];
    UNROLL
    for (int j = 0; j <= ROOT_COUNT; ++j)
    {
        p[j] = 1.0f;
        previous[j] = 1.0f;
        sum[j] = j == 0 ? factor.inverse_h[0] : 0.0f;   // the term for k = 0
    }
    UNROLL
    for (int k = 0; k < ROOT_COUNT; ++k)
    {
        if (k >= degree) continue;
        // From the highest coefficient down: coefficient j of p_{k+1} needs j and j - 1 of p_k. Products with 0 are left out, which
        // a compiler must not do.
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

/// The weight 1 / K(z, z) of the node z = z_f + 1/t; 0 for t = 0, which is a node at infinity. degree: as in kernel_of_degree.
///
/// With 1/t = s/u, q_k = u^k p_k(z) obeys q_{k+1} = ((z_f - a_k) u + s) q_k - (h_k / h_{k-1}) u^2 q_{k-1}. So the weight is
/// u^(2n) / (sum of u^(2(n-k)) q_k^2 / h_k) with n = degree. s and u are at most 1, so nothing overflows.
FN float node_weight_of_degree(float t, IN(Query) query, IN(Factor) factor, int degree)
{
    PRECISE float s = 1.0f / max(abs(t), 1.0f);
    PRECISE float u = t * s;            // (s, u) is (1, t), scaled so that the larger component is at most 1
    PRECISE float u2 = u * u;
    PRECISE float previous = 1.0f;
    PRECISE float q = query.offset[0] * u + s;             // q_1; q_k = u^k p_k(z)
    PRECISE float kernel = u2 * factor.inverse_h[0] + q * q * factor.inverse_h[1];
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

/// The number of nodes whose masses mass_in_front.glsl adds up.
#define KNOWN_NODES (ROOT_COUNT / 2)

/// 1 for a node in front of the query depth, otherwise 0.
FN float node_in_front(float t, IN(Query) query)
{
    return t < 0.0f ? 1.0f : 0.0f;
}

/// v_l of Algorithm 1: 1 for a node in front of the query depth, 0 for a node behind it.
FN float node_value(float t, IN(Query) query, IN(Basis) basis)
{
    return node_in_front(t, query);
}

/// The mass in front of the query depth if there are two nodes, at z_f + 1/t1 and z_f + 1/t2. rest: the mass of both.
///
/// The masses of the canonical representation sum to 1, and their mean is a_0. So w_1 + w_2 = rest and
/// w_1 / t_1 + w_2 / t_2 = a_0 - z_f. For t_1 = front and t_2 = behind this gives
/// w_1 = front ((z_f - a_0) behind + rest) / (front - behind).
FN float mass_in_front_of_two(float t1, float t2, float rest, IN(Query) query)
{
    float front = min(t1, t2);
    float behind = max(t1, t2);
    PRECISE float lone = front * (query.offset[0] * behind + rest) / (front - behind);
    float mixed = clamp(lone, 0.0f, rest);   // if one is in front and one is behind
    return front < 0.0f ? (behind < 0.0f ? rest : mixed) : 0.0f;
}
