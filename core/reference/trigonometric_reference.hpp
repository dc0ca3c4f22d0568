// trigonometric_reference.hpp -- Algorithm 2 with the wrapping zone (paper, Eq. 6), in any precision. Each
// moment vector takes one Toeplitz factorisation. Each depth then takes a triangular solve, m bracketed roots
// of a real function of the angle, and the weights by moment matching.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "core/reference/bracketed_root.hpp"
#include "core/reference/circle_kernel.hpp"
#include "core/reference/point_masses.hpp"
#include "core/reference/triangular_factor.hpp"

namespace momentscope::reference {

/// What does not depend on depth. reference_half: exp(i angle / 2) for the nodes of the canonical
/// representation through one arbitrary fixed angle. The nodes through any other angle interlace with these,
/// which brackets them.
template <std::size_t M, class Real>
struct TrigonometricFactor {
    static_assert(M >= 1, "Algorithm 2 needs at least one moment");
    TrigonometricMoments<M, Real> moments{};
    TriangularFactor<Real, Complex<Real>, M + 1> toeplitz;
    std::array<Complex<Real>, M + 1> reference_half{};
};

/// Results of Algorithm 2 as fractions of the absorbance, not clamped. These are NOT bounds (paper, Section
/// 5.1). node[0] = x0. The others follow in the order of growing angle, starting from x0.
template <std::size_t M, class Real>
struct TrigonometricValues {
    Real beta0{};
    Real beta1{};  // beta0 + w0
    Real w0{};     // 1 / (v^H G^-1 v)
    std::array<Complex<Real>, M + 1> node{};
    std::array<Real, M + 1> weight{};  // by moment matching; weight[0] equals w0 up to rounding
};

/// The nodes through a fixed angle, as half angles. The roots of the kernels of degree k and k + 1 interlace
/// within (0, 2 pi): the phase of the Blaschke product of degree k + 1 is that of degree k, moved forward by
/// less than one turn.
template <std::size_t M, class Real>
std::array<Complex<Real>, M + 1> reference_support(
    const TriangularFactor<Real, Complex<Real>, M + 1>& toeplitz) {
    const Complex<Real> start = unit<Real>(Real(1) / Real(2));  // any but 0, where queries are frequent
    std::array<Real, M + 2> end{};                              // places: x0, the roots so far, 2
    end[1] = Real(2);
    for (std::size_t degree = 1; degree <= M; ++degree) {
        const CircleKernel<M, Real> kernel = circle_kernel<M, Real>(toeplitz, start * start, degree);
        const std::array<Real, M + 2> before = end;
        for (std::size_t l = 1; l <= degree; ++l)
            end[l] = bracketed_root(kernel, before[l - 1], before[l], l % 2 == 0);
        end[degree + 1] = Real(2);
    }
    std::array<Complex<Real>, M + 1> half{};
    Real unused;
    for (std::size_t l = 0; l <= M; ++l) half[l] = start * half_of_place(end[l], unused);
    return half;
}

/// Prepares normalised, biased moments b_0 to b_M (b_0 = 1) for queries. nullopt if the Toeplitz matrix
/// G_ij = b_{i-j} = E[x^i conj(x^j)] is not positive definite to working precision.
template <std::size_t M, class Real>
std::optional<TrigonometricFactor<M, Real>> factor_trigonometric(
    const TrigonometricMoments<M, Real>& moments) {
    SquareMatrix<Complex<Real>, M + 1> toeplitz{};
    for (std::size_t row = 0; row <= M; ++row)
        for (std::size_t column = 0; column <= M; ++column)
            toeplitz[row][column] = row >= column ? moments[row - column] : conjugate(moments[column - row]);
    const auto factor = triangular_factor<Real>(toeplitz);
    if (!factor) return std::nullopt;
    return TrigonometricFactor<M, Real>{moments, *factor, reference_support<M, Real>(*factor)};
}

/// Places of the M roots of the kernel, relative to x0 = half0^2. The nodes of reference_half divide the
/// circle into arcs. One arc holds x0, and each of the M others holds one root. place[0] = 0 is x0.
template <std::size_t M, class Real>
std::array<Real, M + 1> trigonometric_places(const TrigonometricFactor<M, Real>& factor,
                                             const CircleKernel<M, Real>& kernel,
                                             const Complex<Real>& half0) {
    std::array<Real, M + 1> end{};
    for (std::size_t l = 0; l <= M; ++l) end[l] = place_of_half(factor.reference_half[l] * conjugate(half0));
    std::sort(end.begin(), end.end());
    std::array<Real, M + 1> place{};
    for (std::size_t l = 1; l <= M; ++l) place[l] = bracketed_root(kernel, end[l - 1], end[l], l % 2 == 0);
    return place;
}

/// E[prod_{j != l} (x - x_j) / (x_l - x_j)], the weight of node l: row l of the inverse Vandermonde matrix of
/// Algorithm 2, applied to b.
template <std::size_t M, class Real>
Real matched_weight(const TrigonometricMoments<M, Real>& moments,
                    const std::array<Complex<Real>, M + 1>& node, std::size_t l) {
    std::array<Complex<Real>, M + 1> lagrange{};
    lagrange[0].re = Real(1);
    std::size_t degree = 0;
    for (std::size_t j = 0; j <= M; ++j) {
        if (j == l) continue;
        const Complex<Real> scale = inverse(node[l] - node[j]);
        ++degree;
        for (std::size_t k = degree; k > 0; --k)
            lagrange[k] = (lagrange[k - 1] - node[j] * lagrange[k]) * scale;
        lagrange[0] = Complex<Real>{} - node[j] * lagrange[0] * scale;
    }
    Real sum(0);
    for (std::size_t k = 0; k <= M; ++k) sum += (lagrange[k] * moments[k]).re;
    return sum;
}

/// psi on the unit circle (paper, Section 5.2), in [-1, 7). It grows with the angle in [0, 2 pi), without
/// inverse functions.
template <class Real>
Real psi(const Complex<Real>& x) {
    using std::abs;
    Real r = abs(x.im) - abs(x.re);
    if (x.re < Real(0)) r = Real(2) - r;
    if (x.im < Real(0)) r = Real(6) - r;
    return r;
}

/// v(x_l, x0) of Eq. 6. psi grows with the angle, so comparisons of psi are made with places, where rounding
/// cannot confuse neighbours. Only the ramp needs psi. theta <= 0: no ramp (Eq. 4).
template <class Real>
struct FrontFraction {
    Real wrap;          // place of angle 2 pi; roots beyond it have wrapped around, in front of x0
    Real zone;          // place of x(1), the start of the wrapping zone
    Real psi_of_far{};  // psi(x(1))

    FrontFraction(const Real& phase0, const Real& theta)
        : wrap(place_of_offset(Real(Real(2) * pi<Real>() - phase0))), zone(wrap) {
        if (!(theta > Real(0))) return;
        const Real far = Real(2) * pi<Real>() - theta;
        zone = place_of_offset(Real(far - phase0));
        psi_of_far = psi(unit<Real>(far));
    }
    Real operator()(const Real& place, const Complex<Real>& x) const {
        if (place >= wrap) return Real(1);
        if (place <= zone) return Real(0);
        const Real order = psi(x);
        if (order < Real(1)) return Real(1);  // rounded beyond 2 pi; within the zone psi is at least 3
        return std::clamp(Real((order - psi_of_far) / (Real(7) - psi_of_far)), Real(0), Real(1));
    }
};

/// Algorithm 2 for beta = 0 and for beta = 1. theta in [0, 2 pi): the angle of the wrapping zone, the same as
/// for the moments.
template <std::size_t M, class Real>
TrigonometricValues<M, Real> trigonometric_values(const TrigonometricFactor<M, Real>& factor, const Real& z0,
                                                  const Real& theta) {
    const Real phase0 = phase_of_depth(z0, theta);
    const Complex<Real> half0 = unit<Real>(phase0 / Real(2));
    const CircleKernel<M, Real> kernel = circle_kernel<M, Real>(factor.toeplitz, half0 * half0, M);
    const std::array<Real, M + 1> place = trigonometric_places(factor, kernel, half0);
    const FrontFraction<Real> front_fraction(phase0, theta);
    TrigonometricValues<M, Real> values;
    Real unused;
    for (std::size_t l = 0; l <= M; ++l) {
        const Complex<Real> half = half0 * half_of_place(place[l], unused);
        values.node[l] = half * half;
    }
    values.w0 = Real(1) / kernel.inverse_weight;
    for (std::size_t l = 0; l <= M; ++l) {
        values.weight[l] = matched_weight<M, Real>(factor.moments, values.node, l);
        if (l > 0) values.beta0 += values.weight[l] * front_fraction(place[l], values.node[l]);
    }
    values.beta1 = values.beta0 + values.w0;
    return values;
}

/// The same for a single depth. nullopt if factor_trigonometric returns nullopt.
template <std::size_t M, class Real>
std::optional<TrigonometricValues<M, Real>> trigonometric_values(const TrigonometricMoments<M, Real>& moments,
                                                                 const Real& z0, const Real& theta) {
    const auto factor = factor_trigonometric<M, Real>(moments);
    if (!factor) return std::nullopt;
    return trigonometric_values(*factor, z0, theta);
}

}  // namespace momentscope::reference
