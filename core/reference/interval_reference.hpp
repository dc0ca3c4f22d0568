// interval_reference.hpp -- sharp bounds of the absorbance from power moments if all of it lies in [-1, 1],
// in any precision.
#pragma once
#include "core/reference/power_reference.hpp"

namespace momentscope::reference {

/// The factors of the moments of a measure mu on [-1, 1] and of the inner measure (1 - z^2) dmu, and the mass
/// of the latter.
template <std::size_t M, class Real>
struct IntervalFactor {
    PowerFactor<M, Real> whole;
    PowerFactor<M - 2, Real> inner;
    Real inner_mass{};
};

/// moments: normalised to b_0 = 1. nullopt if a matrix is not positive definite to working precision: the
/// moments then determine the measure.
template <std::size_t M, class Real>
std::optional<IntervalFactor<M, Real>> factor_interval(const PowerMoments<M, Real>& moments) {
    PowerMoments<M - 2, Real> inner{};
    const Real mass = moments[0] - moments[2];
    if (!(mass > Real(0))) return std::nullopt;
    for (std::size_t k = 0; k <= M - 2; ++k) inner[k] = (moments[k] - moments[k + 2]) / mass;
    const auto of_whole = factor_power<M, Real>(moments);
    const auto of_inner = factor_power<M - 2, Real>(inner);
    if (!of_whole || !of_inner) return std::nullopt;
    return IntervalFactor<M, Real>{*of_whole, *of_inner, mass};
}

/// The least mass in front of z0 and the greatest mass at z0, as shares of the whole.
template <class Real>
struct MassesAt {
    Real in_front{};
    Real at_depth{};
};

/// z0 in [-1, 1]. If the distribution that attains the bounds of the whole line has nodes beyond an end, both
/// ends become nodes. The inner measure gives the other masses, and the mean that of the near end.
template <std::size_t M, class Real>
MassesAt<Real> interval_masses(const IntervalFactor<M, Real>& factor, const Real& z0) {
    const Real one(1);
    const auto line = power_bounds(factor.whole, z0);
    const bool inside = std::ranges::all_of(line.depth, [&](const Real& z) { return z >= -one && z <= one; });
    if (inside || z0 <= -one || z0 >= one) return {line.lower, line.w0};
    const auto inner = power_bounds(factor.inner, z0);
    MassesAt<Real> result;
    Real to_far(0);  // the sum of w (1 - z), to which the far end adds nothing
    for (std::size_t l = 0; l < inner.depth.size(); ++l) {
        const Real z = inner.depth[l];
        if (!(z > -one && z < one)) continue;  // by rounding only, or at infinity, with no mass
        const Real weight = factor.inner_mass * inner.weight[l] / ((one - z) * (one + z));
        to_far += weight * (one - z);
        if (l == 0) result.at_depth = weight;
        if (l > 0 && z < z0) result.in_front += weight;
    }
    const Real near = (one - factor.whole.moments[1] - to_far) / Real(2);
    result.in_front += std::max(near, Real(0));
    return result;
}

}  // namespace momentscope::reference
