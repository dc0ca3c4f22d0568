// trigonometric_reference_test.cpp -- tests Algorithm 2: against analytic results, against 50 digits, and by
// brute force.
#include <gtest/gtest.h>

#include "tests/property/wide_numbers.hpp"
#include "tests/reference/reference_test_support.hpp"

namespace momentscope::reference {
namespace {

template <class Count>
class Trigonometric : public testing::Test {};
using TrigonometricCounts =
    testing::Types<std::integral_constant<std::size_t, 2>, std::integral_constant<std::size_t, 3>,
                   std::integral_constant<std::size_t, 4>>;
TYPED_TEST_SUITE(Trigonometric, TrigonometricCounts);

/// Eq. 6 as printed: four cases with comparisons of psi.
Long printed_psi(C x) {
    const auto& [re, im] = x;
    if (re >= 0 && im >= 0) return -re + im;
    if (re < 0 && im >= 0) return 2 - re - im;
    return re < 0 ? 4 + re - im : 6 + re + im;
}
Long printed_fraction(C x, C x0, Long theta) {
    const Long far = printed_psi(unit<Long>(2 * pi<Long>() - theta));
    if (printed_psi(x) < printed_psi(x0)) return 1;
    return theta <= 0 || printed_psi(x) <= far ? 0 : (printed_psi(x) - far) / (7 - far);
}

/// Algorithm 2 for beta = 0 by scanning the circle for zeros of the kernel; negative if the scan did not find
/// all of them.
template <std::size_t M>
Long scan_circle(const TrigonometricMoments<M, Long>& b, Long phase0, Long theta) {
    const auto moment = [&](std::size_t i, std::size_t j) {
        return i >= j ? b[i - j] : C{b[j - i].re, -b[j - i].im};
    };
    std::vector<std::vector<C>> toeplitz(M + 1);
    std::vector<C> v(M + 1), right(M + 1);
    for (std::size_t i = 0; i <= M; ++i) {
        for (std::size_t j = 0; j <= M; ++j) toeplitz[i].push_back(moment(i, j));
        v[i] = unit<Long>(Long(i) * phase0);
        right[i] = moment(i, 0);
    }
    const auto q = eliminate(toeplitz, v);
    const auto kernel = [&](const Long& angle) -> Long {
        C sum;
        for (std::size_t j = 0; j <= M; ++j) sum = sum + C{q[j].re, -q[j].im} * unit<Long>(Long(j) * angle);
        return (sum * unit<Long>(-Long(M) * (angle - phase0) / 2)).re;
    };
    std::vector<C> node{v[1]};
    const Long step = 2 * pi<Long>() / 3000;
    for (int i = 0; i < 3000; ++i) {
        Long low = phase0 + Long(i) * step, high = low + step;
        const bool sign = kernel(low) > 0;
        if (sign == (kernel(high) > 0)) continue;
        for (int k = 0; k < 64; ++k) ((kernel((low + high) / 2) > 0) == sign ? low : high) = (low + high) / 2;
        node.push_back(unit<Long>(low));
    }
    if (node.size() != M + 1) return -1;
    std::vector<std::vector<C>> vandermonde(M + 1);
    for (std::size_t j = 0; j <= M; ++j)
        for (const C& x : node) vandermonde[j].push_back(power(x, j));
    const auto weight = eliminate(vandermonde, right);
    Long sum = 0;
    for (std::size_t l = 1; l <= M; ++l) sum += weight[l].re * printed_fraction(node[l], node[0], theta);
    return sum;
}

TYPED_TEST(Trigonometric, AgreesWithAScanOfTheCircle) {
    constexpr std::size_t M = TypeParam::value;
    using std::abs;
    Random random(5);
    int scanned = 0, rays = 150;
    for (int ray = 0; ray < rays; ++ray) {
        const Long theta = ray % 3 == 0 ? Long(0) : Long(pi<Long>() / (ray % 3 == 1 ? 10 : 2));
        const auto masses = convert<Long>(random_masses(random, 1 + std::size_t(ray % 10), 0));
        const auto factor = trigonometric_factor<M, Long>(masses, 1e-3L, theta);
        ASSERT_TRUE(factor);
        const Long z0 = ray % 2 ? masses[0].depth : Long(uniform(random, -1, 1));
        const auto values = trigonometric_values(*factor, z0, theta);
        const Long scan = scan_circle<M>(factor->moments, phase_of_depth(z0, theta), theta);
        if (scan < 0) continue;  // two roots lie within one step of the scan
        ++scanned;
        EXPECT_LT(abs(Long(values.beta0 - scan)), 1e-9L);
    }
    EXPECT_GT(scanned, rays * 9 / 10);
}

TYPED_TEST(Trigonometric, SupportReproducesTheMomentsAndIncludesX0) {
    constexpr std::size_t M = TypeParam::value;
    using std::abs;
    Random random(6);
    for (int ray = 0; ray < 300; ++ray) {
        const Long theta = ray % 2 ? Long(0) : Long(pi<Long>() / 10);
        const auto masses = convert<Long>(random_masses(random, 1 + std::size_t(ray % 10), 0));
        const auto factor = trigonometric_factor<M, Long>(masses, TRIGONOMETRIC_ALPHA[M], theta);
        ASSERT_TRUE(factor);
        const Long ends[] = {-1, 1, masses[0].depth};
        const auto values = trigonometric_values(*factor, ends[ray % 3], theta);
        for (std::size_t j = 0; j <= M; ++j) {
            C sum;
            for (std::size_t l = 0; l <= M; ++l) sum = sum + power(values.node[l], j) * values.weight[l];
            EXPECT_LT(modulus(sum - factor->moments[j]), 1e-9L);
            EXPECT_GE(values.weight[j], -1e-9L);
        }
        EXPECT_LT(abs(Long(values.w0 - values.weight[0])), 1e-9L);
        if (theta != 0 || ray % 3 == 2) continue;
        const Long known = ray % 3 == 0 ? values.beta0 : values.beta1 - 1;  // no mass before -1, all up to 1
        EXPECT_LT(abs(known), 1e-9L);
    }
}

TYPED_TEST(Trigonometric, FewMassesAreExactAtTheirOwnDepths) {
    constexpr std::size_t M = TypeParam::value;
    const Wide theta = pi<Wide>() / 10;
    Random random(7);
    for (std::size_t ray = 0; ray < 60; ++ray) {
        const auto masses = convert<Wide>(random_masses(random, 1 + ray % (M + 1), .1));
        const auto factor = trigonometric_factor<M, Wide>(masses, Wide("1e-20"), theta);
        ASSERT_TRUE(factor);
        for (const auto& mass : masses) {
            const auto values = trigonometric_values(*factor, mass.depth, theta);
            EXPECT_LT(abs(values.beta0 - fraction_in_front(masses, mass.depth)), 1e-9);
            EXPECT_LT(abs(values.w0 - mass.absorbance / power_moments<0>(view(masses))[0]), 1e-9);
        }
    }
}

TYPED_TEST(Trigonometric, LongDoubleAgreesWithFiftyDigits) {
    constexpr std::size_t M = TypeParam::value;
    Random random(8);
    std::vector<double> own, elsewhere;
    for (std::size_t ray = 0; ray < 300; ++ray) {
        const auto masses = random_masses(random, 1 + ray % 10, 0);
        const auto narrow =
            trigonometric_factor<M, Long>(convert<Long>(masses), TRIGONOMETRIC_ALPHA[M], pi<Long>() / 10);
        const auto wide = trigonometric_factor<M, Wide>(convert<Wide>(masses), Wide(TRIGONOMETRIC_ALPHA[M]),
                                                        pi<Wide>() / 10);
        ASSERT_TRUE(narrow && wide);
        const auto error = [&](double z0) {
            const auto a = trigonometric_values(*narrow, Long(z0), pi<Long>() / 10);
            const auto b = trigonometric_values(*wide, Wide(z0), Wide(pi<Wide>() / 10));
            return std::max(double(abs(test::widened<Wide>(a.beta0) - b.beta0)),
                            double(abs(test::widened<Wide>(a.w0) - b.w0)));
        };
        for (const auto& mass : masses) own.push_back(error(mass.depth));
        for (int i = 0; i < 4; ++i) elsewhere.push_back(error(uniform(random, -1, 1)));
    }
    EXPECT_LT(report("trigonometric, own depths:   ", M, own), 1e-9);
    EXPECT_LT(report("trigonometric, random depths:", M, elsewhere), 1e-9);
}

TYPED_TEST(Trigonometric, RefusesWhatIsNotPositiveDefinite) {
    constexpr std::size_t M = TypeParam::value;
    EXPECT_FALSE((trigonometric_factor<M, Long>({{Long(.3), Long(1)}}, 0, 0)));  // rank 1
    auto moments = uniform_bias<M, Long>();
    EXPECT_TRUE((factor_trigonometric<M, Long>(moments)));
    moments[1].im = 1.01L;  // longer than b_0
    EXPECT_FALSE((factor_trigonometric<M, Long>(moments)));
}

}  // namespace
}  // namespace momentscope::reference
