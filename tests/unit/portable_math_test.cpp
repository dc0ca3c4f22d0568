// portable_math_test.cpp -- compares the shared log, exp, sincos, exact float pairs, depth warp and opacity
// cap with long double. An ulp is an ulp of the exact result, 2^(exponent - 23).
#include "core/support/glsl.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

#include "core/reference/extended.hpp"

namespace momentscope::glsl::tested_math {
#include "shaders/shared/portable_math.glsl"
// portable_math first, because fragment.glsl uses it
#include "shaders/shared/float_pair.glsl"
#include "shaders/shared/fragment.glsl"
}  // namespace momentscope::glsl::tested_math

namespace {

using namespace momentscope::glsl::tested_math;
using Long = long double;  // 53 bits would do
using momentscope::reference::Extended;
using Bits = std::uint32_t;

Long wide(float x) {
    return static_cast<Long>(x);
}

Long ulps(float computed, Long exact) {
    const int exponent = std::max(std::ilogb(exact), -126);
    return std::fabs(wide(computed) - exact) / std::ldexp(Long(1), exponent - 23);
}

/// Calls `visit` for every stride-th float of [low, high], 0 < low < high.
template <class Visit>
void for_floats(float low, float high, Bits stride, const Visit& visit) {
    for (Bits bits = std::bit_cast<Bits>(low); bits <= std::bit_cast<Bits>(high); bits += stride)
        visit(std::bit_cast<float>(bits));
}

/// The worst error of `function` in ulps over the floats of [low, high].
template <class Function, class Exact>
Long worst_ulps(float low, float high, Bits stride, const Function& function, const Exact& exact) {
    Long worst = 0;
    for_floats(low, high, stride,
               [&](float x) { worst = std::max(worst, ulps(function(x), exact(wide(x)))); });
    return worst;
}

template <class Function>
void expect_ascending(float low, float high, Bits stride, const Function& function) {
    float before = function(low);
    for_floats(low, high, stride, [&](float x) {
        ASSERT_LE(before, function(x)) << x;
        before = function(x);
    });
}

constexpr float MIN_NORMAL = 0x1p-126f;
constexpr float GREATEST = 0x1.fffffep127f;

TEST(PortableLog, IsWithinTwoUlpsOfEveryNormalFloat) {
    const auto exact = [](Long x) { return std::log(x); };
    // Measured: 1.85 over every 101st normal float, 1.97 (near 1.004) over all floats of [0.25, 4].
    EXPECT_LT(worst_ulps(MIN_NORMAL, 0.999999f, 2003, portable_log, exact), Long(2));
    EXPECT_LT(worst_ulps(1.000001f, GREATEST, 2003, portable_log, exact), Long(2));
    EXPECT_EQ(portable_log(1.0f), 0.0f);
}

TEST(PortableLog, AscendsAcrossTheSeamsOfItsMantissa) {
    // Check both sides of sqrt(1/2), 1, sqrt 2 and 2 float by float: a seam where values step back would
    // disorder depths.
    for (const float seam : {0.707106781f, 1.0f, 1.41421356f, 2.0f})
        expect_ascending(seam * 0.999f, seam * 1.001f, 1, portable_log);
    expect_ascending(MIN_NORMAL, GREATEST, 4001, portable_log);
}

TEST(NegativeLogOneMinus, KeepsItsDigitsForTheFaintestFragments) {
    const auto exact = [](Long x) { return -std::log1p(-x); };
    // Measured over [1e-30, cap]: 2.69 (at 0.3933, where ln(mantissa) cancels against e ln 2). The limit 3
    // leaves a margin.
    EXPECT_LT(worst_ulps(1e-30f, OPACITY_CAP, 499, negative_log_one_minus, exact), Long(3));
    // Below 0.25, where no exponent is split off, measured 0.05 at 1/255 and 1.7 in all.
    EXPECT_LT(worst_ulps(1e-30f, 0.25f, 499, negative_log_one_minus, exact), Long(2));
    EXPECT_LT(ulps(negative_log_one_minus(1.0f / 255.0f), exact(wide(1.0f / 255.0f))), Long(1));
    EXPECT_EQ(negative_log_one_minus(1e-30f), 1e-30f);
    EXPECT_EQ(negative_log_one_minus(0.0f), 0.0f);
}

TEST(NegativeLogOneMinus, AscendsWithOpacity) {
    expect_ascending(0.292f, 0.294f, 1, negative_log_one_minus);  // 1 - sqrt(1/2): the first split exponent
    expect_ascending(1e-30f, OPACITY_CAP, 499, negative_log_one_minus);
}

TEST(PortableExp, IsWithinTwoUlpsAndNeverAboveOneForAbsorbances) {
    const auto exact = [](Long x) { return std::exp(x); };
    // Measured: 1.01 (at -5.89).
    EXPECT_LT(worst_ulps(1e-10f, 88.0f, 499, portable_exp, exact), Long(1.5));
    const auto decay = [](float x) { return portable_exp(-x); };
    EXPECT_LT(worst_ulps(1e-10f, 87.0f, 499, decay, [](Long x) { return std::exp(-x); }), Long(1.5));
    for_floats(1e-10f, 88.0f, 97, [&](float x) { ASSERT_LE(decay(x), 1.0f) << x; });
    EXPECT_EQ(portable_exp(0.0f), 1.0f);
}

TEST(PortableExp, FlushesToTheEndsOfTheNormalFloats) {
    EXPECT_EQ(portable_exp(-1e30f), portable_exp(-87.0f));
    EXPECT_EQ(portable_exp(1e30f), portable_exp(88.0f));
    EXPECT_GT(portable_exp(-1e30f), MIN_NORMAL);
    EXPECT_LT(portable_exp(1e30f), GREATEST);
}

TEST(PortableExp, InvertsTheLogarithm) {
    // ln x is rounded to 1 ulp of up to 87, which exp magnifies to 87 * 2^-23 = 1.04e-5; twice that for its 2
    // ulps.
    for_floats(1e-37f, 1e37f, 9973,
               [](float x) { ASSERT_NEAR(portable_exp(portable_log(x)) / x, 1.0f, 2.1e-5f); });
}

TEST(PortableSincos, IsAccurateToTwoUlpsOfOneOverZeroToPi) {
    Long sine = 0;
    Long cosine = 0;
    for_floats(1e-6f, PI, 97, [&](float x) {
        const SinCos result = portable_sincos(x);
        sine = std::max(sine, std::fabs(wide(result.sine) - std::sin(wide(x))));
        cosine = std::max(cosine, std::fabs(wide(result.cosine) - std::cos(wide(x))));
    });
    // Measured 2.09e-7 (at 0.01806, where the series ends at 1 and 1 ulp of a term is 1.2e-7) and 1.24e-7.
    EXPECT_LT(sine, Long(2.2e-7));
    EXPECT_LT(cosine, Long(1.3e-7));
}

TEST(PortableSincos, HitsTheAxes) {
    EXPECT_NEAR(portable_sincos(0.0f).sine, 0.0f, 2e-7f);  // 2 ulps of 1, as above; measured 0
    EXPECT_EQ(portable_sincos(0.5f * PI).sine, 1.0f);
    // pi/2 in float is 4.37e-8 too small, so a series about this float alone would give 0.
    EXPECT_NEAR(portable_sincos(0.5f * PI).cosine, -4.3711388e-8f, 1e-14f);
    EXPECT_NEAR(portable_sincos(PI).sine, -8.7422777e-8f, 2.2e-7f);
}

TEST(InversePowerOfTwo, BringsEveryNormalFloatIntoOneToTwo) {
    for_floats(MIN_NORMAL, 0x1.fffffep125f, 4001, [](float x) {
        const float power = inverse_power_of_two(x);
        int exponent = 0;
        ASSERT_EQ(std::frexp(power, &exponent), 0.5f) << x;
        ASSERT_GE(x * power, 1.0f) << x;
        ASSERT_LT(x * power, 2.0f) << x;
    });
}

/// A float of random sign and with a random exponent of at most `exponent` in magnitude.
float random_float(std::mt19937& random, int exponent) {
    const float mantissa = std::uniform_real_distribution<float>(1.0f, 2.0f)(random);
    const int power = std::uniform_int_distribution<int>(-exponent, exponent)(random);
    return std::ldexp((random() & 1) != 0 ? mantissa : -mantissa, power);
}

Long value_of(const FloatPair& pair) {
    return wide(pair.high) + wide(pair.low);
}

TEST(FloatPair, SumsAndProductsAreExact) {
    std::mt19937 random(1);
    for (int i = 0; i < 1'000'000; ++i) {
        // 24 bits that are 2^36 apart span 60 bits, which 64 bits hold exactly; products have 48 bits.
        const float a = random_float(random, 18);
        const float b = random_float(random, 18);
        const FloatPair sum = exact_sum(a, b);
        const FloatPair product = exact_product(a, b);
        ASSERT_EQ(Extended(sum.high) + Extended(sum.low), Extended(a) + Extended(b)) << a << " + " << b;
        ASSERT_EQ(value_of(product), wide(a) * wide(b)) << a << " * " << b;
        ASSERT_EQ(sum.high, a + b);
        ASSERT_EQ(product.high, a * b);
        const FloatPair halves = halves_of(a);
        ASSERT_EQ(value_of(halves), wide(a));
        for (const float half : {halves.high, halves.low})
            ASSERT_EQ(wide(half * half), wide(half) * wide(half));
    }
    EXPECT_EQ(exact_sum(1.0f, 1e20f).low, 1.0f);
}

FloatPair random_pair(std::mt19937& random) {
    const float high = random_float(random, 6);
    return exact_sum(high, high * std::uniform_real_distribution<float>(-0x1p-24f, 0x1p-24f)(random));
}

TEST(FloatPair, PairsCarryTwiceTheDigitsOfAFloat) {
    std::mt19937 random(2);
    Long product_error = 0;
    Long difference_error = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        const FloatPair a = random_pair(random);
        const FloatPair b = random_pair(random);
        const Long product = value_of(a) * value_of(b);
        const Long difference = value_of(a) - value_of(b);
        const Long size = std::fabs(value_of(a)) + std::fabs(value_of(b));
        product_error = std::max(product_error, std::fabs(value_of(pair_product(a, b)) / product - 1));
        difference_error =
            std::max(difference_error, std::fabs(value_of(pair_difference(a, b)) - difference) / size);
        ASSERT_EQ(value_of(scaled_pair(a, 0.125f)), value_of(a) * Long(0.125));
    }
    // Measured 2^-46.0 and 2^-46.6: a few roundings of 2^-24 of a low part of 2^-24. Without low parts it
    // would be 2^-24.
    EXPECT_LT(product_error, Long(0x1p-45));
    EXPECT_LT(difference_error, Long(0x1p-45));
}

TEST(OpacityCap, HoldsAbsorbanceToTenOnItsFarSideOnly) {
    const float below = std::nextafter(OPACITY_CAP, 0.0f);
    const float cap = absorbance_of_opacity(OPACITY_CAP);
    EXPECT_LE(cap, 10.0f);
    EXPECT_NEAR(cap, 10.0f,
                1e-3f);  // rounding the cap itself to 2^-24 gives 6e-8 / 4.5e-5 = 1.3e-3 of absorbance
    EXPECT_LT(absorbance_of_opacity(below), cap);
    EXPECT_EQ(absorbance_of_opacity(std::nextafter(OPACITY_CAP, 2.0f)), cap);
    EXPECT_EQ(absorbance_of_opacity(1.0f), cap);
    EXPECT_LT(std::exp(-wide(cap)), Long(4.6e-5));  // the rest of a transmittance that should be 0
    EXPECT_EQ(absorbance_of_opacity(0.0f), 0.0f);
}

TEST(DepthWarp, MapsItsRangeOntoMinusOneToOneAndClampsBeyond) {
    for (const auto& [z_min, z_max] :
         {std::pair{0.1f, 100.0f}, {1.0f, 2.0f}, {3.0f, 3.3f}, {1e-30f, 1e30f}}) {
        const DepthWarpFactors warp = depth_warp_factors(z_min, z_max);
        EXPECT_EQ(warped_depth(z_min, warp), -1.0f);
        EXPECT_NEAR(warped_depth(z_max, warp), 1.0f, 3e-7f);  // 3 roundings of numbers near 2
        EXPECT_EQ(warped_depth(0.5f * z_min, warp), -1.0f);
        EXPECT_EQ(warped_depth(2.0f * z_max, warp), 1.0f);
        // The geometric mean. 2 ulps of ln 3 are 2.4e-7, times the scale 2 / ln 1.1 gives 5e-6; the other
        // cases are better.
        const auto mean = static_cast<float>(std::sqrt(wide(z_min) * wide(z_max)));
        EXPECT_NEAR(warped_depth(mean, warp), 0.0f, 1e-5f);
    }
}

TEST(DepthWarp, AscendsAndIsInverted) {
    for (const auto& [z_min, z_max] : {std::pair{0.1f, 100.0f}, {0.01f, 1e4f}, {1.0f, 2.0f}}) {
        const DepthWarpFactors warp = depth_warp_factors(z_min, z_max);
        float before = -1.0f;
        for_floats(z_min, z_max, 101, [&, z_low = z_min](float z) {
            const float depth = warped_depth(z, warp);
            ASSERT_GE(depth, before) << z;
            before = depth;
            // Measured 8.7e-7 (z / z_min = 1e6): depth is rounded to 1.2e-7, times half of ln 1e6.
            ASSERT_NEAR(unwarped_depth(depth, warp) / z, 1.0f, 1.2e-6f) << z << " from " << z_low;
        });
        // Measured 3.6e-7 (1 to 2): view depths near 2 are rounded to 1.2e-7 of 2 / ln 2.
        for (float depth = -1.0f; depth <= 1.0f; depth += 0x1p-12f)
            ASSERT_NEAR(warped_depth(unwarped_depth(depth, warp), warp), depth, 5e-7f);
    }
}

}  // namespace
