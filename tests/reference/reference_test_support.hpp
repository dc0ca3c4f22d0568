// reference_test_support.hpp -- rays, biases, error reports and a simple linear solver for these tests.
#pragma once
#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <iostream>
#include <random>
#include <vector>

#include "core/reference/exact_reconstruction.hpp"
#include "core/reference/extended.hpp"

namespace momentscope::reference {

using Long = Extended;
using Wide = boost::multiprecision::cpp_bin_float_50;
using Random = std::mt19937;

template <class Real>
using Masses = std::vector<PointMass<Real>>;
template <class Real>
std::span<const PointMass<Real>> view(const Masses<Real>& masses) {
    return masses;
}

inline double uniform(Random& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// Depths uniform in [-1, 1] and at least `gap` apart, opacities uniform in [0.05, 0.95]. They are doubles,
/// so that every Real starts from the same numbers.
inline Masses<double> random_masses(Random& random, std::size_t count, double gap) {
    Masses<double> masses;
    while (masses.size() < count) {
        const PointMass<double> mass{uniform(random, -1, 1), -std::log1p(-uniform(random, .05, .95))};
        bool apart = true;
        for (const auto& other : masses) apart = apart && std::abs(other.depth - mass.depth) >= gap;
        if (apart) masses.push_back(mass);
    }
    return masses;
}

template <class Real>
Masses<Real> convert(const Masses<double>& masses) {
    Masses<Real> result;
    for (const auto& mass : masses) result.push_back({Real(mass.depth), Real(mass.absorbance)});
    return result;
}

/// Table 1, 32-bit variants: the even entries of b* (the odd ones are 0) and alpha.
template <std::size_t M>
inline constexpr std::array<double, M / 2 + 1> EVEN_BIAS{};
template <>
inline constexpr std::array<double, 3> EVEN_BIAS<4>{1, .375, .375};
template <>
inline constexpr std::array<double, 4> EVEN_BIAS<6>{1, .48, .451, .45};
template <>
inline constexpr std::array<double, 5> EVEN_BIAS<8>{1, .75, .67666666666666664, .63, .60030303030303034};
inline constexpr double POWER_ALPHA[] = {0, 0, 0, 0, 5e-7, 0, 5e-6, 0, 5e-5};
inline constexpr double TRIGONOMETRIC_ALPHA[] = {0, 0, 4e-7, 8e-7, 1.5e-6};

template <std::size_t M, class Real>
PowerMoments<M, Real> power_bias() {
    PowerMoments<M, Real> bias{};
    for (std::size_t k = 0; k <= M / 2; ++k) bias[2 * k] = Real(EVEN_BIAS<M>[k]);
    return bias;
}

template <std::size_t M, class Real>
auto power_factor(const Masses<Real>& masses, const Real& alpha) {
    return factor_power<M, Real>(
        normalise_and_bias(power_moments<M>(view(masses)), power_bias<M, Real>(), alpha));
}
template <std::size_t M, class Real>
auto trigonometric_factor(const Masses<Real>& masses, const Real& alpha, const Real& theta) {
    return factor_trigonometric<M, Real>(
        normalise_and_bias(trigonometric_moments<M>(view(masses), theta), uniform_bias<M, Real>(), alpha));
}

template <class Real>
Real fraction_in_front(const Masses<Real>& masses, const Real& depth) {
    return absorbance_in_front(view(masses), depth) / power_moments<0>(view(masses))[0];
}

/// Prints quantiles of the errors into the log of the test; returns the 99 % quantile.
inline double report(const char* what, std::size_t m, std::vector<double> errors) {
    std::sort(errors.begin(), errors.end());
    const auto quantile = [&](double q) {
        return errors[static_cast<std::size_t>(q * double(errors.size() - 1))];
    };
    std::cout << what << " m=" << m << ": " << errors.size() << " queries, median " << quantile(.5)
              << ", 99 % " << quantile(.99) << ", 99.9 % " << quantile(.999) << ", worst " << errors.back()
              << "\n";
    return quantile(.99);
}

using C = Complex<Long>;
inline Long modulus(const C& a) {
    using std::sqrt;
    return sqrt(squared_modulus(a));
}
inline C power(const C& x, std::size_t exponent) {
    C result{1, 0};
    for (std::size_t k = 0; k < exponent; ++k) result = result * x;
    return result;
}

/// Plain Gaussian elimination with row exchanges. It shares nothing with the factorisation of the references.
inline std::vector<C> eliminate(std::vector<std::vector<C>> a, std::vector<C> b) {
    const std::size_t n = b.size();
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t best = k;
        for (std::size_t i = k; i < n; ++i)
            best = squared_modulus(a[i][k]) > squared_modulus(a[best][k]) ? i : best;
        std::swap(a[k], a[best]);
        std::swap(b[k], b[best]);
        for (std::size_t i = k + 1; i < n; ++i) {
            const C scale = a[i][k] * inverse(a[k][k]);
            for (std::size_t j = k; j < n; ++j) a[i][j] = a[i][j] - scale * a[k][j];
            b[i] = b[i] - scale * b[k];
        }
    }
    for (std::size_t k = n; k-- > 0;) {
        for (std::size_t j = k + 1; j < n; ++j) b[k] = b[k] - a[k][j] * b[j];
        b[k] = b[k] * inverse(a[k][k]);
    }
    return b;
}

}  // namespace momentscope::reference
