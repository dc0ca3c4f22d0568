// exact.inl -- the exact function of a technique in numbers of any precision. exact.cpp compiles it for the
// precision of the program, and tests for others.
#pragma once
#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

#include "core/inspect/exact.hpp"
#include "core/reference/exact_reconstruction.hpp"
#include "core/techniques/quantisation.hpp"

namespace momentscope::any_precision {

template <class Number>
std::vector<reference::PointMass<Number>> exact_masses(const ViewRay& ray) {
    using std::log1p;
    const Number greatest = 10;  // as OPACITY_CAP in shaders/shared/fragment.glsl
    std::vector<reference::PointMass<Number>> masses;
    for (const Fragment& fragment : ray.fragments) {
        if (!(fragment.opacity > 0)) continue;
        const Number absorbance = -log1p(-static_cast<Number>(fragment.opacity));
        masses.push_back({static_cast<Number>(fragment.depth), std::min(absorbance, greatest)});
    }
    return masses;
}

/// std::lerp, which takes only built-in numbers.
template <class Number>
Number mixed(const Number& a, const Number& b, const Number& share) {
    if constexpr (std::is_floating_point_v<Number>)
        return std::lerp(a, b, share);
    else
        return a + share * (b - a);
}

// Table 1 of the supplementary. It is typed again here, so that a mistake in shaders/ shows.
template <class Number, std::size_t M>
reference::PowerMoments<M, Number> table_bias(int bits) {
    const auto of = [](auto... entries) {
        return reference::PowerMoments<M, Number>{static_cast<Number>(entries)...};
    };
    if constexpr (M == 4) {
        if (bits == 16) return of(1, 0, 0.628L, 0, 0.628L);
        return of(1, 0, 0.375L, 0, 0.375L);
    } else if constexpr (M == 6) {
        if (bits == 16) return of(1, 0, 0.5566L, 0, 0.489L, 0, 0.47869382L);
        return of(1, 0, 0.48L, 0, 0.451L, 0, 0.45L);
    } else {
        if (bits == 16) return of(1, 0, 0.424749164L, 0, 0.224078027L, 0, 0.153692308L, 0, 0.129004405L);
        return of(1, 0, 0.75L, 0, 0.67666666666666664L, 0, 0.63L, 0, 0.60030303030303034L);
    }
}

// The moments that 16-bit numbers in [0, 1] represent, times b0. The transform is Theta*_m for power moments
// and b/2 + 1/2 for others; this is its inverse.
template <class Number, std::size_t M>
std::array<Number, M + 1> unquantised(const MomentVector& stored, bool theta_transform) {
    std::array<Number, M + 1> moments{};
    const Number b0 = static_cast<Number>(stored.b0);
    const auto code = [&](std::size_t i) {
        using std::round;
        return Number(round(static_cast<Number>(stored.b[i]) * 65535) / 65535);
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
                moments[2 * i + 1] +=
                    b0 * static_cast<Number>(ODD[i][j]) * (code(2 * j) - static_cast<Number>(0.5L));
                moments[2 * i + 2] += b0 * static_cast<Number>(EVEN[i][j]) *
                                      (code(2 * j + 1) - static_cast<Number>(TRANSFORM.even_offset[j]));
            }
        }
    }
    return moments;
}

template <class Number, std::size_t M>
std::array<Number, M + 1> real_moments(const MomentVector& stored, int bits, bool theta_transform) {
    if (bits == 16) return unquantised<Number, M>(stored, theta_transform);
    std::array<Number, M + 1> moments{};
    moments[0] = static_cast<Number>(stored.b0);
    for (std::size_t i = 0; i < M; ++i) moments[i + 1] = static_cast<Number>(stored.b[i]);
    return moments;
}

template <class Number, std::size_t M>
std::optional<ExactFunctionOf<Number>> on_the_line(const reference::PowerMoments<M, Number>& moments,
                                                   const reference::PowerMoments<M, Number>& bias,
                                                   Number alpha) {
    const auto factor =
        reference::factor_power<M, Number>(reference::normalise_and_bias(moments, bias, alpha));
    if (!factor) return std::nullopt;
    return [factor = *factor](Number depth) {
        const auto bounds = reference::power_bounds(factor, depth);
        return ExactFractionOf<Number>{bounds.lower, bounds.w0};
    };
}

// The sharp bounds of the pixel's own interval. depth: in that interval.
template <class Number, std::size_t M>
std::optional<ExactFunctionOf<Number>> between_ends(const reference::PowerMoments<M, Number>& moments,
                                                    const reference::PowerMoments<M, Number>& bias,
                                                    Number alpha) {
    const auto factor =
        reference::factor_interval<M, Number>(reference::normalise_and_bias(moments, bias, alpha));
    if (!factor) return std::nullopt;
    return [factor = *factor](Number depth) {
        const auto masses = reference::interval_masses(factor, depth);
        return ExactFractionOf<Number>{masses.in_front, masses.at_depth};
    };
}

// The exact function of a line, of the depths that the moments are taken of.
template <class Number, std::size_t M>
std::optional<ExactFunctionOf<Number>> on_a_line(const reference::PowerMoments<M, Number>& moments,
                                                 const reference::PowerMoments<M, Number>& bias,
                                                 const ResolvedParameters& p) {
    const auto alpha = static_cast<Number>(p.alpha);
    if (p.in_own_interval()) return between_ends<Number, M>(moments, bias, alpha);
    return on_the_line<Number, M>(moments, bias, alpha);
}

template <class Number, std::size_t M>
std::optional<ExactFunctionOf<Number>> on_the_circle(
    const reference::TrigonometricMoments<M, Number>& moments, Number alpha, Number theta) {
    const auto factor = reference::factor_trigonometric<M, Number>(
        reference::normalise_and_bias(moments, reference::uniform_bias<M, Number>(), alpha));
    if (!factor) return std::nullopt;
    return [factor = *factor, theta](Number depth) {
        const auto values = reference::trigonometric_values(factor, depth, theta);
        return ExactFractionOf<Number>{values.beta0, values.w0};
    };
}

template <class Number, std::size_t M>
std::optional<reference::PowerFactor<M, Number>> first_moments(
    const reference::PowerMoments<8, Number>& moments, Number alpha) {
    reference::PowerMoments<M, Number> first{};
    std::copy_n(moments.begin(), M + 1, first.begin());
    return reference::factor_power<M, Number>(
        reference::normalise_and_bias(first, reference::arcsine_moments<Number, M>(), alpha));
}

// The choice of nested orders (shaders/shared/nested_orders.glsl), in real numbers.
template <class Number>
std::optional<ExactFunctionOf<Number>> with_nested_orders(const reference::PowerMoments<8, Number>& moments,
                                                          Number alpha, Number tolerance) {
    const auto of_4 = first_moments<Number, 4>(moments, alpha);
    const auto of_8 = first_moments<Number, 8>(moments, alpha);
    if (!of_4 || !of_8) return std::nullopt;
    return [lower = *of_4, higher = *of_8, b0 = moments[0], tolerance](Number depth) {
        const auto with_4 = reference::power_bounds(lower, depth);
        const auto with_8 = reference::power_bounds(higher, depth);
        using std::exp;
        using std::expm1;
        const Number greatest = exp(-b0 * std::clamp(with_4.lower, Number(0), Number(1)));
        const Number wider = greatest * -expm1(-b0 * std::max(Number(with_4.w0 - with_8.w0), Number(0)));
        const Number x = std::clamp(Number(wider / tolerance - 1), Number(0), Number(1));
        const Number share = x * x * (3 - 2 * x);
        return ExactFractionOf<Number>{mixed(with_4.lower, with_8.lower, share),
                                       mixed(with_4.w0, with_8.w0, share)};
    };
}

template <class Number, BasisId basis, std::size_t M, int bits>
struct Exact {
    using Masses = std::span<const reference::PointMass<Number>>;

    static std::optional<ExactFunctionOf<Number>> of_masses(Masses masses, const ResolvedParameters& p) {
        [[maybe_unused]] const auto alpha = static_cast<Number>(p.alpha);
        [[maybe_unused]] const auto theta = static_cast<Number>(p.theta);
        if constexpr (basis == BasisId::power)
            return on_a_line<Number, M>(reference::power_moments<M>(masses), table_bias<Number, M>(bits), p);
        else if constexpr (basis == BasisId::chebyshev)
            return on_a_line<Number, M>(reference::power_moments<M>(masses),
                                        reference::arcsine_moments<Number, M>(), p);
        else if constexpr (basis == BasisId::nested)
            return with_nested_orders(reference::power_moments<M>(masses), alpha,
                                      static_cast<Number>(p.tolerance));
        else if constexpr (basis == BasisId::trigonometric)
            return on_the_circle<Number, M>(reference::trigonometric_moments<M>(masses, theta), alpha, theta);
        else
            return std::nullopt;
    }

    static std::optional<ExactFunctionOf<Number>> of_stored(const MomentVector& stored,
                                                            const ResolvedParameters& p) {
        [[maybe_unused]] const auto alpha = static_cast<Number>(p.alpha);
        if constexpr (basis == BasisId::power) {
            return on_a_line<Number, M>(real_moments<Number, M>(stored, bits, true),
                                        table_bias<Number, M>(bits), p);
        } else if constexpr (basis == BasisId::chebyshev) {
            return on_a_line<Number, M>(
                reference::power_of_chebyshev<Number, M>(real_moments<Number, M>(stored, bits, false)),
                reference::arcsine_moments<Number, M>(), p);
        } else if constexpr (basis == BasisId::nested) {
            return with_nested_orders(
                reference::power_of_chebyshev<Number, M>(real_moments<Number, M>(stored, bits, false)), alpha,
                static_cast<Number>(p.tolerance));
        } else if constexpr (basis == BasisId::trigonometric) {
            const auto flat = real_moments<Number, 2 * M>(stored, bits, false);
            reference::TrigonometricMoments<M, Number> moments{};
            moments[0] = {flat[0], 0};
            for (std::size_t i = 1; i <= M; ++i) moments[i] = {flat[2 * i - 1], flat[2 * i]};
            return on_the_circle<Number, M>(moments, alpha, static_cast<Number>(p.theta));
        } else {
            return std::nullopt;
        }
    }
};

// Calls `use` with the Exact of a technique and returns the result; nullopt for techniques without moments.
template <class Number, typename Use>
std::optional<ExactFunctionOf<Number>> with_exact(const Technique& technique, const Use& use) {
    if (!technique.has_moments()) return std::nullopt;
    const MomentMath& math = technique.moments();
#define MOMENT_TECHNIQUE(row, basis_id, count, bits_of, ...)                   \
    if (math.basis->id == BasisId::basis_id && math.moment_count == (count) && \
        math.kernel->bits == (bits_of))                                        \
        return use(Exact<Number, BasisId::basis_id, count, bits_of>());
#include "core/techniques/moment_techniques.def"
#undef MOMENT_TECHNIQUE
    return std::nullopt;
}

// Takes scene depths to the interval between the ends.
template <class Number>
std::optional<ExactFunctionOf<Number>> of_scene_depths(std::optional<ExactFunctionOf<Number>> function,
                                                       const reference::RaySteps<Number>& steps) {
    if (!function) return std::nullopt;
    return [function = std::move(*function), steps](Number depth) {
        return function(reference::in_interval(depth, steps));
    };
}

// The two functions of exact.hpp.

template <class Number>
std::optional<ExactFunctionOf<Number>> exact_function(const ViewRay& ray, const Technique& technique,
                                                      const ResolvedParameters& parameters) {
    auto masses = exact_masses<Number>(ray);
    if (masses.empty()) return std::nullopt;
    reference::RaySteps<Number> steps;
    if (parameters.in_own_interval()) {
        steps = reference::steps_of_masses<Number>(masses);
        for (auto& mass : masses) mass.depth = reference::in_interval(mass.depth, steps);
    }
    return of_scene_depths(
        with_exact<Number>(technique, [&](auto exact) { return exact.of_masses(masses, parameters); }),
        steps);
}

template <class Number>
std::optional<ExactFunctionOf<Number>> exact_function_of_stored(const MomentVector& stored,
                                                                const Technique& technique,
                                                                const ResolvedParameters& parameters) {
    if (!(stored.b0 > 0)) return std::nullopt;
    reference::RaySteps<Number> steps;
    if (parameters.in_own_interval())
        steps = {static_cast<Number>(stored.near_step), static_cast<Number>(stored.far_step)};
    return of_scene_depths(
        with_exact<Number>(technique, [&](auto exact) { return exact.of_stored(stored, parameters); }),
        steps);
}

}  // namespace momentscope::any_precision
