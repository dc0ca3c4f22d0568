// point_masses.hpp -- the truth along a ray as a list of point masses, with its step function and its
// moments.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "core/reference/complex.hpp"

namespace momentscope::reference {

/// One fragment. depth: warped, in [-1, 1]. absorbance: -ln(1 - opacity), >= 0.
template <class Real>
struct PointMass {
    Real depth;
    Real absorbance;
};

/// The moments b_0 to b_M: power moments (paper, Section 4.1) or trigonometric moments (paper, Section 5.1;
/// b_0 has no imaginary part).
template <std::size_t M, class Real>
using PowerMoments = std::array<Real, M + 1>;
template <std::size_t M, class Real>
using TrigonometricMoments = std::array<Complex<Real>, M + 1>;

/// A(z): the absorbance strictly in front of `depth` (paper, Section 3.1). A fragment does not occlude
/// itself.
template <class Real>
Real absorbance_in_front(std::span<const PointMass<Real>> masses, const Real& depth) {
    Real sum(0);
    for (const PointMass<Real>& mass : masses)
        if (mass.depth < depth) sum += mass.absorbance;
    return sum;
}

/// T(z) = exp(-A(z)) (paper, Eq. 1 and Section 3.1).
template <class Real>
Real transmittance(std::span<const PointMass<Real>> masses, const Real& depth) {
    using std::exp;
    const Real absorbance = absorbance_in_front(masses, depth);
    return exp(-absorbance);
}

/// Power moments: b_j = sum of absorbance * depth^j. Not normalised.
template <std::size_t M, class Real>
PowerMoments<M, Real> power_moments(std::span<const PointMass<Real>> masses) {
    PowerMoments<M, Real> moments{};
    for (const PointMass<Real>& mass : masses) {
        Real term = mass.absorbance;
        for (Real& moment : moments) {
            moment += term;
            term *= mass.depth;
        }
    }
    return moments;
}

/// The angle of x(z) (paper, Eq. 5) in radians, in [0, 2 pi - theta] for depths in [-1, 1].
template <class Real>
Real phase_of_depth(const Real& depth, const Real& theta) {
    return (depth + Real(1)) * (pi<Real>() - theta / Real(2));
}

/// Trigonometric moments: b_j = sum of absorbance * x(depth)^j (paper, Eq. 5). theta in [0, 2 pi). Not
/// normalised.
template <std::size_t M, class Real>
TrigonometricMoments<M, Real> trigonometric_moments(std::span<const PointMass<Real>> masses,
                                                    const Real& theta) {
    TrigonometricMoments<M, Real> moments{};
    for (const PointMass<Real>& mass : masses) {
        const Complex<Real> point = unit<Real>(phase_of_depth(mass.depth, theta));
        Complex<Real> power{Real(1), Real(0)};
        for (std::size_t j = 0; j <= M; ++j) {
            moments[j] = moments[j] + power * mass.absorbance;
            power = power * point;
        }
    }
    return moments;
}

/// (1 - alpha) b / b_0 + alpha b* (supplementary, Section 1). Requires b_0 > 0. bias_moments[0] is 1.
template <class Real, class Scalar, std::size_t Count>
std::array<Scalar, Count> normalise_and_bias(const std::array<Scalar, Count>& moments,
                                             const std::array<Scalar, Count>& bias_moments,
                                             const Real& alpha) {
    const Real scale = (Real(1) - alpha) / real_part(moments[0]);
    std::array<Scalar, Count> biased{};
    for (std::size_t j = 0; j < Count; ++j) biased[j] = moments[j] * scale + bias_moments[j] * alpha;
    return biased;
}

/// b* = (1, 0, ..., 0) for trigonometric moments: the uniform distribution on the circle.
template <std::size_t M, class Real>
TrigonometricMoments<M, Real> uniform_bias() {
    TrigonometricMoments<M, Real> bias{};
    bias[0].re = Real(1);
    return bias;
}

}  // namespace momentscope::reference
