// reference_test.cpp -- tests the truth and Algorithm 1: against analytic results, against 50 digits, and as
// bounds.
#include <gtest/gtest.h>

#include "tests/property/wide_numbers.hpp"
#include "tests/reference/reference_test_support.hpp"

namespace momentscope::reference {
namespace {

TEST(PointMasses, StepFunctionIsStrictAndMomentsAreThoseOfOneMass) {
    const Masses<Wide> masses{{Wide(.25), Wide(2)}, {Wide(-.5), Wide(1)}};
    EXPECT_EQ(absorbance_in_front(view(masses), Wide(-.5)), 0);
    EXPECT_EQ(absorbance_in_front(view(masses), Wide(.25)), 1);
    EXPECT_EQ(absorbance_in_front(view(masses), Wide(1)), 3);
    EXPECT_LT(abs(transmittance(view(masses), Wide(0)) - exp(Wide(-1))), 1e-45);

    const Masses<Wide> one{{Wide(0), Wide(2)}};  // phase pi - theta / 2; theta = 2 pi / 3 makes that 2 pi / 3
    const auto moments = trigonometric_moments<3>(view(one), Wide(2 * pi<Wide>() / 3));
    EXPECT_LT(abs(moments[1].re + 1), 1e-45);
    EXPECT_LT(abs(moments[1].im - sqrt(Wide(3))), 1e-45);
    EXPECT_LT(abs(moments[3].re - 2), 1e-45);
    EXPECT_EQ(power_moments<4>(view(masses))[2], Wide(.375));
}

template <class Count>
class Power : public testing::Test {};
using PowerCounts =
    testing::Types<std::integral_constant<std::size_t, 4>, std::integral_constant<std::size_t, 6>,
                   std::integral_constant<std::size_t, 8>>;
TYPED_TEST_SUITE(Power, PowerCounts);

TYPED_TEST(Power, SupportReproducesTheMomentsAndW0IsTheChristoffelFunction) {
    constexpr std::size_t M = TypeParam::value;
    using std::abs;
    using std::isinf;
    using std::pow;
    Random random(1);
    for (int ray = 0; ray < 200; ++ray) {
        const auto masses = convert<Long>(random_masses(random, 1 + std::size_t(ray % 10), 0));
        const auto factor = power_factor<M, Long>(masses, POWER_ALPHA[M]);
        ASSERT_TRUE(factor);
        const Long z0 = ray % 2 ? masses[0].depth : Long(uniform(random, -1, 1));
        const auto bounds = power_bounds(*factor, z0);
        std::vector<std::vector<C>> hankel(M / 2 + 1);
        std::vector<C> v(M / 2 + 1);
        for (std::size_t j = 0; j <= M; ++j) {
            Long sum = 0;
            for (std::size_t l = 0; l <= M / 2; ++l)
                if (bounds.weight[l] != 0) sum += bounds.weight[l] * pow(bounds.depth[l], int(j));
            if (j < M || !(isinf(bounds.depth[1]) || isinf(bounds.depth[M / 2]))) {
                EXPECT_LT(abs(Long(sum - factor->moments[j])), 1e-9L);
            }
        }
        for (std::size_t i = 0; i <= M / 2; ++i) {
            for (std::size_t j = 0; j <= M / 2; ++j) hankel[i].push_back({factor->moments[i + j], 0});
            v[i].re = pow(z0, int(i));
            EXPECT_GE(bounds.weight[i], -1e-9L);
        }
        const auto q = eliminate(hankel, v);
        C inverse_weight;
        for (std::size_t i = 0; i <= M / 2; ++i) inverse_weight = inverse_weight + q[i] * v[i];
        EXPECT_LT(modulus(inverse_weight * bounds.w0 - C{1, 0}), 1e-9L);
        EXPECT_LT(abs(Long(bounds.w0 - bounds.weight[0])), 1e-9L);
    }
}

TYPED_TEST(Power, FewMassesAreExactAtTheirOwnDepths) {
    constexpr std::size_t M = TypeParam::value;
    Random random(2);
    for (std::size_t ray = 0; ray < 60; ++ray) {
        const auto masses = convert<Wide>(random_masses(random, 1 + ray % (M / 2 + 1), .1));
        const auto factor = power_factor<M, Wide>(masses, Wide("1e-20"));
        ASSERT_TRUE(factor);
        for (const auto& mass : masses) {
            const auto bounds = power_bounds(*factor, mass.depth);
            const Wide own = mass.absorbance / power_moments<0>(view(masses))[0];
            EXPECT_LT(abs(bounds.lower - fraction_in_front(masses, mass.depth)), 1e-9);
            EXPECT_LT(abs(bounds.w0 - own), 1e-9);
        }
    }
}

TYPED_TEST(Power, BoundsHoldForTheBiasedMeasureAndGrow) {
    constexpr std::size_t M = TypeParam::value;
    const auto bias_support = power_bounds<M, Long>(power_bias<M, Long>(), .3L);  // has moments b*
    ASSERT_TRUE(bias_support);
    Random random(3);
    for (int ray = 0; ray < 100; ++ray) {
        auto masses = convert<Long>(random_masses(random, 2 + std::size_t(ray % 9), 0));
        const Long alpha = ray % 2 ? .05L : 1e-4L;
        const auto factor = power_factor<M, Long>(masses, alpha);
        ASSERT_TRUE(factor);
        const Long total = power_moments<0>(view(masses))[0];
        for (auto& mass : masses) mass.absorbance *= (1 - alpha) / total;
        for (std::size_t l = 0; l <= M / 2; ++l)
            masses.push_back({bias_support->depth[l], bias_support->weight[l] * alpha});
        Long lower_before = 0, upper_before = 0;
        for (int i = 0; i <= 400; ++i) {
            const Long z0 = -1 + Long(i) / 200;
            const auto bounds = power_bounds(*factor, z0);
            const Long truth = absorbance_in_front(view(masses), z0);
            EXPECT_LE(bounds.lower, truth + 1e-9L);
            EXPECT_GE(bounds.upper, truth - 1e-9L);
            EXPECT_GE(bounds.lower, lower_before - 1e-9L);
            EXPECT_GE(bounds.upper, upper_before - 1e-9L);
            lower_before = bounds.lower;
            upper_before = bounds.upper;
        }
    }
}

TYPED_TEST(Power, LongDoubleAgreesWithFiftyDigits) {
    constexpr std::size_t M = TypeParam::value;
    Random random(4);
    std::vector<double> own, elsewhere;
    for (std::size_t ray = 0; ray < 400; ++ray) {
        const auto masses = random_masses(random, 1 + ray % 10, 0);
        const auto narrow = power_factor<M, Long>(convert<Long>(masses), POWER_ALPHA[M]);
        const auto wide = power_factor<M, Wide>(convert<Wide>(masses), Wide(POWER_ALPHA[M]));
        ASSERT_TRUE(narrow && wide);
        const auto error = [&](double z0) {
            const auto a = power_bounds(*narrow, Long(z0));
            const auto b = power_bounds(*wide, Wide(z0));
            return std::max(double(abs(test::widened<Wide>(a.lower) - b.lower)),
                            double(abs(test::widened<Wide>(a.w0) - b.w0)));
        };
        for (const auto& mass : masses) own.push_back(error(mass.depth));
        for (int i = 0; i < 4; ++i) elsewhere.push_back(error(uniform(random, -1, 1)));
    }
    EXPECT_LT(report("power, own depths:   ", M, own), 1e-9);
    EXPECT_LT(report("power, random depths:", M, elsewhere), 1e-9);
}

TYPED_TEST(Power, RefusesWhatIsNotPositiveDefinite) {
    constexpr std::size_t M = TypeParam::value;
    EXPECT_FALSE((power_factor<M, Long>({{Long(.3), Long(1)}}, 0)));  // rank 1
    auto moments = power_bias<M, Long>();
    EXPECT_TRUE((factor_power<M, Long>(moments)));
    moments[2] = moments[4] + (1 - moments[4]) * 2;  // variance of z^2 would be negative
    EXPECT_FALSE((factor_power<M, Long>(moments)));
}

TEST(PowerSix, RootAtInfinityHasWeightZero) {
    // b* is symmetric, so p_3 is odd and 0 is a Gauss node. q_3 vanishes there, and the support is the Gauss
    // rule.
    const auto factor = factor_power<6, Wide>(power_bias<6, Wide>());
    ASSERT_TRUE(factor);
    for (const char* z0 : {"0", "1e-30", "-1e-30"}) {
        const auto bounds = power_bounds(*factor, Wide(z0));
        EXPECT_LT(abs(bounds.w0 - (1 - Wide(EVEN_BIAS<6>[1]) * EVEN_BIAS<6>[1] / EVEN_BIAS<6>[2])), 1e-15);
        const Wide far = std::max(abs(bounds.depth[1]), abs(bounds.depth[3]));
        EXPECT_GT(far, 1e25);
        EXPECT_LT(abs(bounds.lower - (1 - bounds.w0) / 2), 1e-25);
    }
    EXPECT_TRUE(isinf(power_bounds(*factor, Wide(0)).depth[1]) ||
                isinf(power_bounds(*factor, Wide(0)).depth[3]));
}

TEST(PowerEight, MisprintOfTableOneIsIndefinite) {
    auto moments = power_bias<8, Long>();
    moments[6] = .64L;
    EXPECT_FALSE((factor_power<8, Long>(moments)));
}

}  // namespace
}  // namespace momentscope::reference
