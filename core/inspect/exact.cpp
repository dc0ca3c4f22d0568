#include "core/inspect/exact.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/reference/exact_reconstruction.hpp"
#include "core/techniques/quantisation.hpp"

namespace momentscope {

namespace {

using Masses = std::span<const reference::PointMass<Real>>;

std::vector<reference::PointMass<Real>> exact_masses(const ViewRay& ray) {
    constexpr Real MAX_ABSORBANCE = 10;  // as OPACITY_CAP in shaders/shared/fragment.glsl
    std::vector<reference::PointMass<Real>> masses;
    for (const Fragment& fragment : ray.fragments)
        if (fragment.opacity > 0)
            masses.push_back({static_cast<Real>(fragment.depth),
                              std::min(-std::log1p(-static_cast<Real>(fragment.opacity)), MAX_ABSORBANCE)});
    return masses;
}

// Table 1 of the supplementary. It is typed again here, so that a mistake in shaders/ shows.
template <std::size_t M>
reference::PowerMoments<M, Real> power_bias(int bits) {
    if constexpr (M == 4) {
        if (bits == 16) return {1, 0, 0.628L, 0, 0.628L};
        return {1, 0, 0.375L, 0, 0.375L};
    } else if constexpr (M == 6) {
        if (bits == 16) return {1, 0, 0.5566L, 0, 0.489L, 0, 0.47869382L};
        return {1, 0, 0.48L, 0, 0.451L, 0, 0.45L};
    } else {
        if (bits == 16) return {1, 0, 0.424749164L, 0, 0.224078027L, 0, 0.153692308L, 0, 0.129004405L};
        return {1, 0, 0.75L, 0, 0.67666666666666664L, 0, 0.63L, 0, 0.60030303030303034L};
    }
}

// The power moments (2k)! / (4^k k!^2) of the arcsine distribution, towards which Chebyshev moments are
// biased.
template <std::size_t M>
reference::PowerMoments<M, Real> arcsine_moments() {
    reference::PowerMoments<M, Real> moments{};
    moments[0] = 1;
    for (std::size_t k = 2; k <= M; k += 2)
        moments[k] = moments[k - 2] * static_cast<Real>(k - 1) / static_cast<Real>(k);
    return moments;
}

/// Converts Chebyshev moments to power moments. z^k is expanded in T_j by z T_j = (T_{j+1} + T_{|j-1|}) / 2.
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

// The moments that 16-bit numbers in [0, 1] represent, times b0. The transform is Theta*_m for power moments
// and b/2 + 1/2 for others; this is its inverse.
template <std::size_t M>
std::array<Real, M + 1> unquantised(const MomentVector& stored, bool theta_transform) {
    std::array<Real, M + 1> moments{};
    const Real b0 = static_cast<Real>(stored.b0);
    const auto code = [&](std::size_t i) {
        return std::round(static_cast<Real>(stored.b[i]) * 65535) / 65535;
    };
    moments[0] = b0;
    if (!theta_transform) {
        for (std::size_t i = 0; i < M; ++i) moments[i + 1] = b0 * (2 * code(i) - 1);
        return moments;
    }
    if constexpr (M % 2 == 0 && M >= 4) {
        constexpr auto TRANSFORM = quantisation_transform<static_cast<int>(M)>();
        constexpr auto ODD = inverse(TRANSFORM.odd);
        constexpr auto EVEN = inverse(TRANSFORM.even);
        for (std::size_t i = 0; i < M / 2; ++i) {
            for (std::size_t j = 0; j < M / 2; ++j) {
                moments[2 * i + 1] += b0 * static_cast<Real>(ODD[i][j]) * (code(2 * j) - 0.5L);
                moments[2 * i + 2] += b0 * static_cast<Real>(EVEN[i][j]) *
                                      (code(2 * j + 1) - static_cast<Real>(TRANSFORM.even_offset[j]));
            }
        }
    }
    return moments;
}

template <std::size_t M>
std::array<Real, M + 1> real_moments(const MomentVector& stored, int bits, bool theta_transform) {
    if (bits == 16) return unquantised<M>(stored, theta_transform);
    std::array<Real, M + 1> moments{};
    moments[0] = static_cast<Real>(stored.b0);
    for (std::size_t i = 0; i < M; ++i) moments[i + 1] = static_cast<Real>(stored.b[i]);
    return moments;
}

template <std::size_t M>
std::optional<ExactFunction> on_the_line(const reference::PowerMoments<M, Real>& moments,
                                         const reference::PowerMoments<M, Real>& bias, Real alpha) {
    const auto factor = reference::factor_power<M, Real>(reference::normalise_and_bias(moments, bias, alpha));
    if (!factor) return std::nullopt;
    return [factor = *factor](Real depth) {
        const auto bounds = reference::power_bounds(factor, depth);
        return ExactFraction{bounds.lower, bounds.w0};
    };
}

template <std::size_t M>
std::optional<ExactFunction> on_the_circle(const reference::TrigonometricMoments<M, Real>& moments,
                                           Real alpha, Real theta) {
    const auto factor = reference::factor_trigonometric<M, Real>(
        reference::normalise_and_bias(moments, reference::uniform_bias<M, Real>(), alpha));
    if (!factor) return std::nullopt;
    return [factor = *factor, theta](Real depth) {
        const auto values = reference::trigonometric_values(factor, depth, theta);
        return ExactFraction{values.beta0, values.w0};
    };
}

template <std::size_t M>
std::optional<reference::PowerFactor<M, Real>> first_moments(const reference::PowerMoments<8, Real>& moments,
                                                             Real alpha) {
    reference::PowerMoments<M, Real> first{};
    std::copy_n(moments.begin(), M + 1, first.begin());
    return reference::factor_power<M, Real>(
        reference::normalise_and_bias(first, arcsine_moments<M>(), alpha));
}

// The choice of nested orders (shaders/shared/nested_orders.glsl), in real numbers.
std::optional<ExactFunction> with_nested_orders(const reference::PowerMoments<8, Real>& moments, Real alpha,
                                                Real tolerance) {
    const auto of_4 = first_moments<4>(moments, alpha);
    const auto of_8 = first_moments<8>(moments, alpha);
    if (!of_4 || !of_8) return std::nullopt;
    return [lower = *of_4, higher = *of_8, b0 = moments[0], tolerance](Real depth) {
        const auto with_4 = reference::power_bounds(lower, depth);
        const auto with_8 = reference::power_bounds(higher, depth);
        const Real greatest = std::exp(-b0 * std::clamp(with_4.lower, Real(0), Real(1)));
        const Real wider = greatest * -std::expm1(-b0 * std::max(with_4.w0 - with_8.w0, Real(0)));
        const Real x = std::clamp(wider / tolerance - 1, Real(0), Real(1));
        const Real share = x * x * (3 - 2 * x);
        return ExactFraction{std::lerp(with_4.lower, with_8.lower, share),
                             std::lerp(with_4.w0, with_8.w0, share)};
    };
}

// True for bases that core/reference has. Rows of other bases compile, too.
constexpr bool has_reference(BasisId id) {
    return id == BasisId::power || id == BasisId::chebyshev || id == BasisId::nested ||
           id == BasisId::trigonometric;
}

template <BasisId basis, std::size_t M, int bits>
struct Exact {
    static std::optional<ExactFunction> of_masses(Masses masses, const ResolvedParameters& p) {
        const auto alpha = static_cast<Real>(p.alpha);
        const auto theta = static_cast<Real>(p.theta);
        if constexpr (basis == BasisId::power)
            return on_the_line<M>(reference::power_moments<M>(masses), power_bias<M>(bits), alpha);
        else if constexpr (basis == BasisId::chebyshev)
            return on_the_line<M>(reference::power_moments<M>(masses), arcsine_moments<M>(), alpha);
        else if constexpr (basis == BasisId::nested)
            return with_nested_orders(reference::power_moments<M>(masses), alpha,
                                      static_cast<Real>(p.tolerance));
        else if constexpr (basis == BasisId::trigonometric)
            return on_the_circle<M>(reference::trigonometric_moments<M>(masses, theta), alpha, theta);
        else
            return std::nullopt;
    }

    static std::optional<ExactFunction> of_stored(const MomentVector& stored, const ResolvedParameters& p) {
        const auto alpha = static_cast<Real>(p.alpha);
        if constexpr (basis == BasisId::power) {
            return on_the_line<M>(real_moments<M>(stored, bits, true), power_bias<M>(bits), alpha);
        } else if constexpr (basis == BasisId::chebyshev) {
            return on_the_line<M>(power_of_chebyshev<M>(real_moments<M>(stored, bits, false)),
                                  arcsine_moments<M>(), alpha);
        } else if constexpr (basis == BasisId::nested) {
            return with_nested_orders(power_of_chebyshev<M>(real_moments<M>(stored, bits, false)), alpha,
                                      static_cast<Real>(p.tolerance));
        } else if constexpr (basis == BasisId::trigonometric) {
            const auto flat = real_moments<2 * M>(stored, bits, false);
            reference::TrigonometricMoments<M, Real> moments{};
            moments[0] = {flat[0], 0};
            for (std::size_t i = 1; i <= M; ++i) moments[i] = {flat[2 * i - 1], flat[2 * i]};
            return on_the_circle<M>(moments, alpha, static_cast<Real>(p.theta));
        } else {
            return std::nullopt;
        }
    }
};

// Calls `use` with the Exact of a technique and returns the result; nullopt for techniques without moments.
template <typename Use>
std::optional<ExactFunction> with_exact(const Technique& technique, const Use& use) {
#define MOMENT_TECHNIQUE(row, basis, count, bits, text, ...) \
    if (std::string_view(technique.id) == (text)) return use(Exact<BasisId::basis, count, bits>());
#include "core/techniques/moment_techniques.def"
#undef MOMENT_TECHNIQUE
    return std::nullopt;
}

}  // namespace

std::optional<ExactFunction> exact_function(const ViewRay& ray, const Technique& technique,
                                            const ResolvedParameters& parameters) {
    const auto masses = exact_masses(ray);
    if (masses.empty()) return std::nullopt;
    return with_exact(technique, [&](auto exact) { return exact.of_masses(masses, parameters); });
}

std::optional<ExactFunction> exact_function_of_stored(const MomentVector& stored, const Technique& technique,
                                                      const ResolvedParameters& parameters) {
    if (!(stored.b0 > 0)) return std::nullopt;
    return with_exact(technique, [&](auto exact) { return exact.of_stored(stored, parameters); });
}

std::vector<double> exact_absorbance(const std::optional<ExactFunction>& exact, const ViewRay& ray,
                                     float beta, std::span<const float> depths) {
    const auto masses = exact_masses(ray);
    const auto here = static_cast<Real>(beta);
    Real total = 0;
    for (const auto& mass : masses) total += mass.absorbance;
    std::vector<double> absorbance;
    absorbance.reserve(depths.size());
    for (const float depth : depths) {
        const auto at = static_cast<Real>(depth);
        if (exact) {
            const Real share = (*exact)(at).with(beta);
            absorbance.push_back(static_cast<double>(total * std::clamp(share, Real(0), Real(1))));
        } else {
            Real sum = 0;
            for (const auto& mass : masses)
                if (mass.depth <= at) sum += mass.absorbance * (mass.depth < at ? 1 : here);
            absorbance.push_back(static_cast<double>(sum));
        }
    }
    return absorbance;
}

std::vector<float> unbiased_absorbance(const ViewRay& ray, const Technique& technique,
                                       const ResolvedParameters& parameters, std::span<const float> depths) {
    if (!technique.has_moments() || !has_reference(technique.moments().basis->id)) return {};
    ResolvedParameters unbiased = parameters;
    unbiased.alpha = 0;
    const auto exact =
        exact_absorbance(exact_function(ray, technique, unbiased), ray, parameters.beta, depths);
    return {exact.begin(), exact.end()};
}

}  // namespace momentscope
