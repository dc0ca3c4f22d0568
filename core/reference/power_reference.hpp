// power_reference.hpp -- Algorithm 1: sharp bounds of the absorbance from power moments, in any precision.
// Each moment vector takes one Hankel factorisation. Each depth then takes a triangular solve, m/2 bracketed
// roots and the weights by moment matching. Nothing is divided by a leading coefficient, so a root may lie at
// infinity.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "core/reference/bracketed_root.hpp"
#include "core/reference/point_masses.hpp"
#include "core/reference/triangular_factor.hpp"

namespace momentscope::reference {

/// What does not depend on depth: the moments, the factor of their Hankel matrix, and the Gauss nodes.
template <std::size_t M, class Real>
struct PowerFactor {
    static_assert(M >= 2 && M % 2 == 0, "Algorithm 1 needs an even number of moments");
    static constexpr std::size_t N = M / 2;
    PowerMoments<M, Real> moments{};
    TriangularFactor<Real, Real, N + 1> hankel;
    std::array<Real, N> gauss_node{};  // ascending
};

/// Bounds of the fraction of the absorbance in front of depth[0] = z0, and the distribution that attains
/// them. depth[1], depth[2], ... ascend. One of them may be +-infinity, with weight 0.
template <std::size_t M, class Real>
struct PowerBounds {
    Real lower{};  // sum of the weights in front of z0
    Real upper{};  // lower + w0
    Real w0{};     // 1 / (v^T H^-1 v)
    std::array<Real, M / 2 + 1> depth{};
    std::array<Real, M / 2 + 1> weight{};  // by moment matching; weight[0] equals w0 up to rounding
};

/// Horner's scheme for a polynomial of the given degree. Returns the value, the slope and the error of the
/// value.
template <class Real, std::size_t Count>
Sample<Real> sample_polynomial(const std::array<Real, Count>& coefficient, std::size_t degree,
                               const Real& z) {
    using std::abs;
    const Real modulus = abs(z);
    Sample<Real> at{coefficient[degree], Real(0), abs(coefficient[degree])};
    for (std::size_t k = degree; k-- > 0;) {
        at.slope = at.slope * z + at.value;
        at.value = at.value * z + coefficient[k];
        at.noise = at.noise * modulus + abs(coefficient[k]);
    }
    at.noise *= std::numeric_limits<Real>::epsilon();
    return at;
}

/// The zeros of the orthogonal polynomial p_N. Those of p_k and p_{k+1} interlace, which brackets each of
/// them.
template <class Real, std::size_t Size>
std::array<Real, Size - 1> gauss_nodes(const TriangularFactor<Real, Real, Size>& hankel) {
    std::array<Real, Size - 1> node{};
    node[0] = -hankel.inverse[1][0];
    for (std::size_t degree = 2; degree < Size; ++degree) {
        const auto polynomial = [&](const Real& z) {
            return sample_polynomial(hankel.inverse[degree], degree, z);
        };
        const std::array<Real, Size - 1> before = node;
        node[0] = outer_root(polynomial, before[0], -1, degree % 2 == 0);
        for (std::size_t i = 1; i + 1 < degree; ++i)
            node[i] = bracketed_root(polynomial, before[i - 1], before[i], (degree - i) % 2 == 1);
        node[degree - 1] = outer_root(polynomial, before[degree - 2], +1, true);
    }
    return node;
}

/// Prepares normalised, biased moments b_0 to b_M (b_0 = 1) for queries. nullopt if the Hankel matrix is not
/// positive definite to working precision.
template <std::size_t M, class Real>
std::optional<PowerFactor<M, Real>> factor_power(const PowerMoments<M, Real>& moments) {
    constexpr std::size_t SIZE = M / 2 + 1;
    SquareMatrix<Real, SIZE> hankel{};
    for (std::size_t row = 0; row < SIZE; ++row)
        for (std::size_t column = 0; column < SIZE; ++column) hankel[row][column] = moments[row + column];
    const auto factor = triangular_factor<Real>(hankel);
    if (!factor) return std::nullopt;
    return PowerFactor<M, Real>{moments, *factor, gauss_nodes(*factor)};
}

/// E[prod_{j != l} (z - z_j) / (z_l - z_j)]: the weight that node l must have so that the moments match. This
/// is row l of the inverse Vandermonde matrix of Algorithm 1, applied to b. For z_j = +-infinity the factor
/// of j tends to 1.
template <std::size_t M, class Real>
Real matched_weight(const PowerMoments<M, Real>& moments, const std::array<Real, M / 2 + 1>& node,
                    std::size_t l) {
    using std::isinf;
    if (isinf(node[l])) return Real(0);
    std::array<Real, M / 2 + 1> lagrange{};
    lagrange[0] = Real(1);
    std::size_t degree = 0;
    for (std::size_t j = 0; j <= M / 2; ++j) {
        if (j == l || isinf(node[j])) continue;
        const Real scale = Real(1) / (node[l] - node[j]);
        ++degree;
        for (std::size_t k = degree; k > 0; --k)
            lagrange[k] = (lagrange[k - 1] - node[j] * lagrange[k]) * scale;
        lagrange[0] = -node[j] * lagrange[0] * scale;
    }
    Real sum(0);
    for (std::size_t k = 0; k <= degree; ++k) sum += lagrange[k] * moments[k];
    return sum;
}

/// The N roots of q. The Gauss nodes divide the line into N + 1 intervals. z0 lies in the interval `home`,
/// and each other interval holds one root. The sign of q at every Gauss node follows from q(z0) = 1 / w0 > 0,
/// because it changes once at every root.
template <std::size_t M, class Real>
void find_power_support(const PowerFactor<M, Real>& factor, const std::array<Real, M / 2 + 1>& q,
                        std::size_t home, std::array<Real, M / 2 + 1>& depth) {
    constexpr std::size_t N = M / 2;
    const auto kernel = [&](const Real& z) { return sample_polynomial(q, N, z); };
    std::size_t next = 1;
    for (std::size_t interval = 0; interval <= N; ++interval) {
        if (interval == home) continue;
        const bool behind = interval > home;
        const std::size_t changes =
            behind ? interval - home : home - interval - 1;  // of sign, between z0 and the high end
        const bool positive_at_high = changes % 2 == 0;
        const Real low = factor.gauss_node[interval > 0 ? interval - 1 : 0];
        const Real high = factor.gauss_node[std::min(interval, N - 1)];
        if (interval == 0)
            depth[next++] = outer_root(kernel, high, -1, !positive_at_high);
        else if (interval == N)
            depth[next++] = outer_root(kernel, low, +1, positive_at_high);
        else
            depth[next++] = bracketed_root(kernel, low, high, positive_at_high);
    }
}

/// Algorithm 1 (paper, Section 4.1) for beta = 0 and for beta = 1. Results are in [0, 1] up to rounding. They
/// are not clamped.
template <std::size_t M, class Real>
PowerBounds<M, Real> power_bounds(const PowerFactor<M, Real>& factor, const Real& z0) {
    constexpr std::size_t N = M / 2;
    std::array<Real, N + 1> v{};
    v[0] = Real(1);
    for (std::size_t k = 1; k <= N; ++k) v[k] = v[k - 1] * z0;
    const auto solution = solve(factor.hankel, v, N);
    std::size_t home = 0;
    while (home < N && factor.gauss_node[home] < z0) ++home;

    PowerBounds<M, Real> bounds;
    bounds.w0 = Real(1) / solution.inverse_weight;
    bounds.depth[0] = z0;
    find_power_support(factor, solution.q, home, bounds.depth);
    for (std::size_t l = 0; l <= N; ++l)
        bounds.weight[l] = matched_weight<M, Real>(factor.moments, bounds.depth, l);
    for (std::size_t l = 1; l <= home; ++l)
        bounds.lower += bounds.weight[l];  // `home` roots lie in front of z0
    bounds.upper = bounds.lower + bounds.w0;
    return bounds;
}

/// The same for a single depth. nullopt if factor_power returns nullopt.
template <std::size_t M, class Real>
std::optional<PowerBounds<M, Real>> power_bounds(const PowerMoments<M, Real>& moments, const Real& z0) {
    const auto factor = factor_power<M, Real>(moments);
    if (!factor) return std::nullopt;
    return power_bounds(*factor, z0);
}

}  // namespace momentscope::reference
