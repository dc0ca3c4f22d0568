// exact_technique.hpp -- what a technique of the registry would compute in long double, through
// core/reference.
#pragma once
#include <algorithm>
#include <functional>
#include <optional>
#include <string>

#include "core/inspect/curve.hpp"
#include "core/reference/exact_reconstruction.hpp"

namespace momentscope::test {

using Real = long double;
using PointMasses = std::vector<reference::PointMass<Real>>;

/// Fractions of b0 in front of a depth, for beta = 0, and the mass at the depth.
struct ExactFraction {
    Real in_front = 0;
    Real query_weight = 0;
};
using ExactFunction = std::function<ExactFraction(Real depth)>;

/// The measure of a ray, exactly from its float depths and opacities.
inline PointMasses point_masses(const ViewRay& ray) {
    PointMasses masses;
    for (const Fragment& f : ray.fragments)
        masses.push_back({static_cast<Real>(f.depth), -std::log1p(-static_cast<Real>(f.opacity))});
    return masses;
}

/// b* of Table 1 of the supplementary for float moments, with the digits of facts in docs/equations.md; typed
/// again here so that a slip in shaders/ shows.
template <std::size_t M>
reference::PowerMoments<M, Real> table1_bias() {
    if constexpr (M == 4) return {1, 0, 0.375L, 0, 0.375L};
    if constexpr (M == 6) return {1, 0, 0.48L, 0, 0.451L, 0, 0.45L};
    if constexpr (M == 8) return {1, 0, 0.75L, 0, 0.67666666666666664L, 0, 0.63L, 0, 0.60030303030303034L};
}

/// Exact functions of one ray: from its exact moments, and from given stored float moments. nullopt where the
/// biased matrix is not positive definite, so that there is no exact result.
struct ExactPair {
    std::optional<ExactFunction> from_exact_moments;
    std::optional<ExactFunction> from_float_moments;
};

template <std::size_t M>
std::optional<ExactFunction> exact_power(const reference::PowerMoments<M, Real>& moments, Real bias) {
    const auto factor =
        reference::factor_power<M, Real>(reference::normalise_and_bias(moments, table1_bias<M>(), bias));
    if (!factor) return std::nullopt;
    return [factor = *factor](Real depth) {
        const auto bounds = reference::power_bounds(factor, depth);
        return ExactFraction{bounds.lower, bounds.w0};
    };
}

template <std::size_t M>
ExactPair exact_power_pair(const ViewRay& ray, const MomentVector& stored, Real bias) {
    const PointMasses masses = point_masses(ray);
    reference::PowerMoments<M, Real> floats{};
    floats[0] = static_cast<Real>(stored.b0);
    for (std::size_t i = 0; i < M; ++i) floats[i + 1] = static_cast<Real>(stored.b[i]);
    return {exact_power<M>(reference::power_moments<M>(std::span<const reference::PointMass<Real>>(masses)),
                           bias),
            exact_power<M>(floats, bias)};
}

/// Chebyshev moments to power moments, exactly: z^k as a sum of T_j, by z T_j = (T_{j+1} + T_{|j-1|}) / 2.
template <std::size_t M>
reference::PowerMoments<M, Real> power_of_chebyshev(const std::array<Real, M + 1>& chebyshev) {
    reference::PowerMoments<M, Real> power{};
    std::array<Real, M + 2> coefficient{};  // of z^k
    coefficient[0] = 1;
    for (std::size_t k = 0; k <= M; ++k) {
        for (std::size_t j = 0; j <= k; ++j) power[k] += coefficient[j] * chebyshev[j];
        std::array<Real, M + 2> next{};
        for (std::size_t j = 0; j <= k && j <= M; ++j) {
            next[j + 1] += coefficient[j] / (j == 0 ? 1 : 2);
            if (j > 0) next[j - 1] += coefficient[j] / 2;
        }
        coefficient = next;
    }
    return power;
}

/// The same distribution in powers, with the arcsine distribution as b*: its power moments are (2k)! / (4^k
/// k!^2).
template <std::size_t M>
ExactPair exact_chebyshev_pair(const ViewRay& ray, const MomentVector& stored, Real bias) {
    reference::PowerMoments<M, Real> arcsine{};
    arcsine[0] = 1;
    for (std::size_t k = 2; k <= M; k += 2)
        arcsine[k] = arcsine[k - 2] * static_cast<Real>(k - 1) / static_cast<Real>(k);
    const auto exact = [&](const reference::PowerMoments<M, Real>& moments) -> std::optional<ExactFunction> {
        const auto factor =
            reference::factor_power<M, Real>(reference::normalise_and_bias(moments, arcsine, bias));
        if (!factor) return std::nullopt;
        return [factor = *factor](Real depth) {
            const auto bounds = reference::power_bounds(factor, depth);
            return ExactFraction{bounds.lower, bounds.w0};
        };
    };
    const PointMasses masses = point_masses(ray);
    std::array<Real, M + 1> floats{};
    floats[0] = static_cast<Real>(stored.b0);
    for (std::size_t i = 0; i < M; ++i) floats[i + 1] = static_cast<Real>(stored.b[i]);
    return {exact(reference::power_moments<M>(std::span<const reference::PointMass<Real>>(masses))),
            exact(power_of_chebyshev<M>(floats))};
}

template <std::size_t M>
std::optional<ExactFunction> exact_trigonometric(const reference::TrigonometricMoments<M, Real>& moments,
                                                 Real bias, Real theta) {
    const auto factor = reference::factor_trigonometric<M, Real>(
        reference::normalise_and_bias(moments, reference::uniform_bias<M, Real>(), bias));
    if (!factor) return std::nullopt;
    return [factor = *factor, theta](Real depth) {
        const auto values = reference::trigonometric_values(factor, depth, theta);
        return ExactFraction{values.beta0, values.w0};
    };
}

template <std::size_t M>
ExactPair exact_trigonometric_pair(const ViewRay& ray, const MomentVector& stored, Real bias, Real theta) {
    const PointMasses masses = point_masses(ray);
    reference::TrigonometricMoments<M, Real> floats{};
    floats[0] = {static_cast<Real>(stored.b0), 0};
    for (std::size_t i = 0; i < M; ++i)
        floats[i + 1] = {static_cast<Real>(stored.b[2 * i]), static_cast<Real>(stored.b[2 * i + 1])};
    const auto exact =
        reference::trigonometric_moments<M>(std::span<const reference::PointMass<Real>>(masses), theta);
    return {exact_trigonometric<M>(exact, bias, theta), exact_trigonometric<M>(floats, bias, theta)};
}

inline ExactPair exact_pair(const Technique& technique, const ViewRay& ray, const MomentVector& stored,
                            const ResolvedParameters& parameters) {
    const auto bias = static_cast<Real>(parameters.alpha);
    const auto theta = static_cast<Real>(parameters.theta);
    const std::string id = technique.id;
    if (id == "power4-32") return exact_power_pair<4>(ray, stored, bias);
    if (id == "power6-32") return exact_power_pair<6>(ray, stored, bias);
    if (id == "power8-32") return exact_power_pair<8>(ray, stored, bias);
    if (id == "cheb4-32") return exact_chebyshev_pair<4>(ray, stored, bias);
    if (id == "cheb6-32") return exact_chebyshev_pair<6>(ray, stored, bias);
    if (id == "cheb8-32") return exact_chebyshev_pair<8>(ray, stored, bias);
    if (id == "trig2-32") return exact_trigonometric_pair<2>(ray, stored, bias, theta);
    if (id == "trig3-32") return exact_trigonometric_pair<3>(ray, stored, bias, theta);
    if (id == "trig4-32") return exact_trigonometric_pair<4>(ray, stored, bias, theta);
    throw std::logic_error("no exact reference for " + id);
}

/// An id as part of a test's name, which must not hold a minus.
inline std::string test_name(const Technique& technique) {
    std::string name = technique.id;
    std::ranges::replace(name, '-', '_');
    return name;
}

inline std::vector<const Technique*> moment_based_techniques() {
    std::vector<const Technique*> rows;
    for (const Technique& row : techniques())
        if (row.kernel != nullptr) rows.push_back(&row);
    return rows;
}

}  // namespace momentscope::test
