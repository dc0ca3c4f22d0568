// real_roots_test.cpp -- the shared solver for polynomials of degree 2, 3 and 4 with only real roots.
//
// Errors are in units of the error that no solver with float coefficients can avoid. A relative change of all
// coefficients by 2^-24 moves a simple root t by 2^-24 sum |e_k t^k| / |p'(t)|, and the roots of a close pair
// by the square root of such a term.
#include "core/support/glsl.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <span>
#include <vector>

namespace momentscope::glsl::degree2 {
#define ROOT_COUNT 2
#include "shaders/shared/real_roots.glsl"
#undef ROOT_COUNT
}  // namespace momentscope::glsl::degree2
namespace momentscope::glsl::degree3 {
#define ROOT_COUNT 3
#include "shaders/shared/real_roots.glsl"
#undef ROOT_COUNT
}  // namespace momentscope::glsl::degree3
namespace momentscope::glsl::degree4 {
#include "shaders/shared/portable_math.glsl"
#define ROOT_COUNT 4
#include "shaders/shared/real_roots.glsl"
#undef ROOT_COUNT
}  // namespace momentscope::glsl::degree4

namespace {

namespace glsl = momentscope::glsl;

/// The roots, or the e of t^n + e[0] t^(n-1) + ... + e[n-1].
template <std::size_t N>
using Numbers = std::array<double, N>;

template <std::size_t N, class Polynomial, class Solver>
Numbers<N> solved_by(const Solver& solver, const Numbers<N>& e) {
    Polynomial p;
    for (std::size_t k = 0; k < N; ++k) p.e[k] = static_cast<float>(e[k]);
    const auto roots = solver(p);
    Numbers<N> t;
    std::copy_n(roots.t, N, t.begin());
    std::ranges::sort(t);
    return t;
}

template <std::size_t N>
Numbers<N> solve(const Numbers<N>& e) {
    if constexpr (N == 2)
        return solved_by<N, glsl::degree2::MonicPolynomial>(
            [](auto p) { return glsl::degree2::real_roots(p); }, e);
    else if constexpr (N == 3)
        return solved_by<N, glsl::degree3::MonicPolynomial>(
            [](auto p) { return glsl::degree3::real_roots(p); }, e);
    else
        return solved_by<N, glsl::degree4::MonicPolynomial>(
            [](auto p) { return glsl::degree4::real_roots(p); }, e);
}

/// Multiplies the leading factor, such as t^2 + ..., by t - root for each root.
std::vector<double> expand(std::vector<double> product, std::span<const double> roots) {
    for (const double root : roots) {
        product.push_back(0);
        for (std::size_t j = product.size() - 1; j > 0; --j) product[j] -= root * product[j - 1];
    }
    return product;
}

template <std::size_t N>
Numbers<N> polynomial_of(const Numbers<N>& roots) {
    const std::vector<double> product = expand({1}, roots);
    Numbers<N> e;
    std::copy_n(product.begin() + 1, N, e.begin());
    return e;
}

/// The distance by which rounding the coefficients to floats moves root i, plus half an ulp of the root
/// itself.
template <std::size_t N>
double unavoidable_error(const Numbers<N>& t, const Numbers<N>& e, std::size_t i) {
    double size = 0;
    for (const double coefficient : e) size = size * std::abs(t[i]) + std::abs(coefficient);
    double others = 1;
    double nearest = HUGE_VAL;
    for (std::size_t j = 0; j < N; ++j) {
        if (j == i) continue;
        others *= std::abs(t[i] - t[j]);
        nearest = std::min(nearest, std::abs(t[i] - t[j]));
    }
    const double simple = others > 0 ? size / others : HUGE_VAL;
    const double pair = nearest > 0 ? std::sqrt(0x1p24 * size * nearest / others) : HUGE_VAL;
    return 0x1p-24 * (std::min(simple, pair) + std::abs(t[i]) + 1e-30);
}

using Random = std::mt19937;

double uniform(Random& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

template <std::size_t N>
Numbers<N> uniform_roots(Random& random, double bound) {
    Numbers<N> t;
    for (double& root : t) root = uniform(random, -bound, bound);
    return t;
}

/// The errors of all roots of 20,000 random polynomials, ascending.
template <std::size_t N>
std::vector<double> sorted_errors(const std::function<Numbers<N>(Random&)>& random_roots) {
    Random random(5);
    std::vector<double> errors;
    for (int i = 0; i < 20'000; ++i) {
        Numbers<N> exact = random_roots(random);
        std::ranges::sort(exact);
        const Numbers<N> e = polynomial_of(exact);
        const Numbers<N> computed = solve(e);
        for (std::size_t k = 0; k < N; ++k) {
            EXPECT_TRUE(std::isfinite(computed[k]));
            errors.push_back(std::abs(computed[k] - exact[k]) / unavoidable_error(exact, e, k));
        }
    }
    std::ranges::sort(errors);
    return errors;
}

/// A quantile: `share` of the errors lie below the result.
double quantile(const std::vector<double>& errors, double share) {
    return errors[static_cast<std::size_t>(share * static_cast<double>(errors.size() - 1))];
}

template <class Degree>
class RealRoots : public testing::Test {
public:
    static constexpr std::size_t DEGREE = Degree::value;
};

using Degrees = testing::Types<std::integral_constant<std::size_t, 2>, std::integral_constant<std::size_t, 3>,
                               std::integral_constant<std::size_t, 4>>;
TYPED_TEST_SUITE(RealRoots, Degrees);

// Measured for degrees 2, 3, 4, in unavoidable errors, median .20 to .30 throughout:
//   magnitudes from .01 to 100      99 % .86 1.2 .76    99.9 % 1.1 2.0 .95    worst 1.5 4.3 3.2
//   one root from 1e4 to 1e6        99 % .85 .93 .74    99.9 % 1.1 1.2 .92    worst 1.4 1.8 2.0
//   two roots 1e-3 apart            99 % 1.2 2.8 1.8    99.9 % 1.4 4.7 5.6    worst 1.9 7.4 9.7
//   nodes at distances up to 2      99 % .95 2.2 .77    99.9 % 1.3 3.3 .99    worst 1.8 5.5 5.4
// So 99 % of roots are nearly as good as their coefficients, and none is far off; those of quartics are
// polished. A third of the errors must exceed a tenth of the unit, lest it be too large to tell anything.
template <std::size_t N>
void expect_as_good_as_the_coefficients(const std::vector<double>& errors) {
    constexpr double PERCENTILE_99 = N == 3 ? 4.0 : 2.0;
    EXPECT_LT(quantile(errors, 0.5), 0.5);
    EXPECT_LT(quantile(errors, 0.99), PERCENTILE_99);
    EXPECT_LT(errors.back(), 20.0);
    EXPECT_GT(quantile(errors, 0.67), 0.1);
}

TYPED_TEST(RealRoots, OfManyMagnitudesAreFound) {
    constexpr std::size_t N = TestFixture::DEGREE;
    expect_as_good_as_the_coefficients<N>(sorted_errors<N>([](Random& random) {
        Numbers<N> t;
        for (double& root : t)
            root = std::copysign(std::pow(10.0, uniform(random, -2, 2)), uniform(random, -1, 1));
        return t;
    }));
}

TYPED_TEST(RealRoots, AreFoundBesideAHugeOne) {
    constexpr std::size_t N = TestFixture::DEGREE;
    expect_as_good_as_the_coefficients<N>(sorted_errors<N>([](Random& random) {
        Numbers<N> t = uniform_roots<N>(random, 1);
        t[0] = std::copysign(std::pow(10.0, uniform(random, 4, 6)), t[0]);
        return t;
    }));
}

TYPED_TEST(RealRoots, AThousandthApartAreFound) {
    constexpr std::size_t N = TestFixture::DEGREE;
    expect_as_good_as_the_coefficients<N>(sorted_errors<N>([](Random& random) {
        Numbers<N> t = uniform_roots<N>(random, 2);
        t[1] = t[0] + 1e-3;
        return t;
    }));
}

TYPED_TEST(RealRoots, OfNodesAtOrdinaryDistancesAreFound) {
    constexpr std::size_t N = TestFixture::DEGREE;
    expect_as_good_as_the_coefficients<N>(sorted_errors<N>([](Random& random) {
        Numbers<N> t = uniform_roots<N>(random, 2);
        for (double& root : t) root = 1 / root;
        return t;
    }));
}

TYPED_TEST(RealRoots, AtZeroAreFoundAsNodesAtInfinity) {
    constexpr std::size_t N = TestFixture::DEGREE;
    Random random(6);
    for (int i = 0; i < 20'000; ++i) {
        Numbers<N> exact = uniform_roots<N>(random, 2);
        for (std::size_t k = 1; k < N; ++k) exact[k] += std::copysign(0.05, exact[k]);
        exact[0] = 0;
        const Numbers<N> t = solve(polynomial_of(exact));
        const auto least = std::ranges::min(t, {}, [](double root) { return std::abs(root); });
        // Measured 3e-7 at worst: rounding of the others, which are at most 2 (1.2e-7). A weight grows at
        // least with t^2.
        ASSERT_LT(std::abs(least), 1e-6);
        for (const double root : t) ASSERT_TRUE(std::isfinite(root));
    }
}

TYPED_TEST(RealRoots, AllAtInfinityCountAsZero) {
    constexpr std::size_t N = TestFixture::DEGREE;
    // Then the errors of a quartic count as a tenth of 2^-20.
    for (const double root : solve(Numbers<N>{})) EXPECT_LE(std::abs(root), 1e-7);
}

TYPED_TEST(RealRoots, OfASlightlyIndefinitePolynomialAreRealAndNear) {
    constexpr std::size_t N = TestFixture::DEGREE;
    Random random(7);
    int off = 0;
    for (int i = 0; i < 30'000; ++i) {
        Numbers<N> exact = uniform_roots<N>(random, 2);
        const double imaginary = std::pow(10.0, uniform(random, -5, -3));
        const double c = exact[1] = exact[0];
        const std::vector<double> pair = {1, -2 * c, c * c + imaginary * imaginary};
        const std::vector<double> product = expand(pair, std::span(exact).subspan(2));
        Numbers<N> e;
        std::copy_n(product.begin() + 1, N, e.begin());
        const Numbers<N> t = solve(e);
        std::ranges::sort(exact);
        double worst = 0;
        for (std::size_t k = 0; k < N; ++k) {
            ASSERT_TRUE(std::isfinite(t[k])) << imaginary;
            worst = std::max(worst, std::abs(t[k] - exact[k]));
        }
        off += worst > 0.1 ? 1 : 0;
    }
    // Measured 0 to 3.
    EXPECT_LT(off, 10);
}

TEST(QuadraticRoots, TakeNoDigitsFromASmallRootAndClampTheDiscriminant) {
    const auto far = glsl::degree2::quadratic_roots(-1e4f, 1.0f);
    EXPECT_EQ(far.first, 1e4f);
    EXPECT_EQ(far.second, 1e-4f);  // -e1/2 - gap would give 0
    EXPECT_EQ(glsl::degree2::quadratic_roots(-2.0f, 1.0001f).first, 1.0f);
}

}  // namespace
