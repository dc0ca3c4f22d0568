#include "core/inspect/ghost.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string_view>

#include "core/reference/exact_reconstruction.hpp"

namespace momentscope {

namespace {

using Real = long double;
using Masses = std::span<const reference::PointMass<Real>>;
using Fraction = std::function<Real(Real depth)>;  // of b0

std::vector<reference::PointMass<Real>> exact_masses(const ViewRay& ray) {
    constexpr Real MOST = 10;  // the opacity cap, as in shaders/shared/fragment.glsl
    std::vector<reference::PointMass<Real>> masses;
    for (const Fragment& fragment : ray.fragments)
        if (fragment.opacity > 0)
            masses.push_back({static_cast<Real>(fragment.depth),
                              std::min(-std::log1p(-static_cast<Real>(fragment.opacity)), MOST)});
    return masses;
}

// nullopt where the matrix is singular: the distribution is the only one with its moments.
template <std::size_t M>
std::optional<Fraction> power(Masses masses, const ResolvedParameters& parameters) {
    const auto moments = reference::normalise_and_bias(reference::power_moments<M>(masses),
                                                       reference::PowerMoments<M, Real>{1}, Real(0));
    const auto factor = reference::factor_power<M, Real>(moments);
    if (!factor) return std::nullopt;
    return [factor = *factor, beta = static_cast<Real>(parameters.beta)](Real depth) {
        const auto bounds = reference::power_bounds(factor, depth);
        return bounds.lower + beta * bounds.w0;
    };
}

template <std::size_t M>
std::optional<Fraction> trigonometric(Masses masses, const ResolvedParameters& parameters) {
    const auto theta = static_cast<Real>(parameters.theta);
    const auto moments = reference::normalise_and_bias(reference::trigonometric_moments<M>(masses, theta),
                                                       reference::uniform_bias<M, Real>(), Real(0));
    const auto factor = reference::factor_trigonometric<M, Real>(moments);
    if (!factor) return std::nullopt;
    return [factor = *factor, theta, beta = static_cast<Real>(parameters.beta)](Real depth) {
        const auto values = reference::trigonometric_values(factor, depth, theta);
        return values.beta0 + beta * values.w0;
    };
}

// A row's basis as a value, so that rows of bases without a reference compile too.
enum class Basis { power, trigonometric, other };

constexpr Basis basis_of(std::string_view name) {
    // Without bias and rounding, Chebyshev moments know exactly what power moments know.
    if (name == "power" || name == "chebyshev") return Basis::power;
    return name == "trigonometric" ? Basis::trigonometric : Basis::other;
}

template <Basis basis, std::size_t M>
std::optional<Fraction> fraction(Masses masses, const ResolvedParameters& parameters) {
    if constexpr (basis == Basis::power) return power<M>(masses, parameters);
    if constexpr (basis == Basis::trigonometric) return trigonometric<M>(masses, parameters);
    return std::nullopt;
}

std::optional<Fraction> exact_fraction(const Technique& technique, Masses masses,
                                       const ResolvedParameters& parameters) {
#define MOMENT_TECHNIQUE(row, basis, count, text, ...) \
    if (std::string_view(technique.id) == (text))      \
        return fraction<basis_of(#basis), count>(masses, parameters);
#include "core/techniques/moment_techniques.def"
#undef MOMENT_TECHNIQUE
    return std::nullopt;
}

Real determined(Masses masses, Real depth, Real beta) {
    Real sum = 0;
    for (const auto& mass : masses)
        if (mass.depth <= depth) sum += mass.absorbance * (mass.depth < depth ? 1 : beta);
    return sum;
}

}  // namespace

std::vector<float> unbiased_absorbance(const ViewRay& ray, const Technique& technique,
                                       const ResolvedParameters& parameters, std::span<const float> depths) {
    if (technique.kernel == nullptr || basis_of(technique.basis) == Basis::other) return {};
    const auto masses = exact_masses(ray);
    if (masses.empty()) return std::vector<float>(depths.size(), 0.0f);
    const auto fraction = exact_fraction(technique, masses, parameters);
    Real total = 0;
    for (const auto& mass : masses) total += mass.absorbance;
    std::vector<float> absorbance;
    absorbance.reserve(depths.size());
    for (const float depth : depths) {
        const auto at = static_cast<Real>(depth);
        absorbance.push_back(
            static_cast<float>(fraction ? total * std::clamp((*fraction)(at), Real(0), Real(1))
                                        : determined(masses, at, static_cast<Real>(parameters.beta))));
    }
    return absorbance;
}

}  // namespace momentscope
