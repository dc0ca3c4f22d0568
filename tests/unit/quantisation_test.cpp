// quantisation_test.cpp -- the transforms of Table 2, their inverses, and rounding to 16 bits.
#include "core/techniques/quantisation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/inspect/exact.hpp"

namespace momentscope::test {
namespace {

template <int M>
void expect_unit_range() {
    constexpr auto TRANSFORM = quantisation_transform<M>();
    constexpr std::size_t N = M / 2;
    // Every row is an affine function of the odd or the even powers of z. It must fill [0, 1] exactly.
    for (std::size_t i = 0; i < N; ++i) {
        double odd_least = 2, odd_most = -1, even_least = 2, even_most = -1;
        for (int step = -100'000; step <= 100'000; ++step) {
            const double z = step * 1e-5;
            double odd = 0.5;
            double even = TRANSFORM.even_offset[i];
            for (std::size_t j = 0; j < N; ++j) {
                odd += TRANSFORM.odd[i][j] * std::pow(z, 2 * static_cast<int>(j) + 1);
                even += TRANSFORM.even[i][j] * std::pow(z, 2 * static_cast<int>(j) + 2);
            }
            odd_least = std::min(odd_least, odd);
            odd_most = std::max(odd_most, odd);
            even_least = std::min(even_least, even);
            even_most = std::max(even_most, even);
        }
        // The printed digits are accurate to 1e-8; the grid of 1e-5 misses extremes by up to 1e-8.
        EXPECT_NEAR(odd_least, 0, 3e-8) << "m = " << M << ", odd row " << i;
        EXPECT_NEAR(odd_most, 1, 3e-8) << "m = " << M << ", odd row " << i;
        EXPECT_NEAR(even_least, 0, 3e-8) << "m = " << M << ", even row " << i;
        EXPECT_NEAR(even_most, 1, 3e-8) << "m = " << M << ", even row " << i;
    }
}

TEST(Quantisation, EveryRowMapsDepthsOntoTheUnitRange) {
    expect_unit_range<4>();
    expect_unit_range<6>();
    expect_unit_range<8>();
}

template <std::size_t N>
void expect_inverse(const SquareMatrix<N>& matrix) {
    const SquareMatrix<N> back = inverse(matrix);
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t j = 0; j < N; ++j) {
            double sum = 0;
            for (std::size_t k = 0; k < N; ++k) sum += matrix[i][k] * back[k][j];
            EXPECT_NEAR(sum, i == j ? 1 : 0, 1e-12);  // entries up to 127, conditions up to a few hundred
        }
}

TEST(Quantisation, InversesInvert) {
    expect_inverse(quantisation_transform<4>().odd);
    expect_inverse(quantisation_transform<4>().even);
    expect_inverse(quantisation_transform<6>().odd);
    expect_inverse(quantisation_transform<6>().even);
    expect_inverse(quantisation_transform<8>().odd);
    expect_inverse(quantisation_transform<8>().even);
}

std::vector<const Technique*> of_16_bits() {
    std::vector<const Technique*> rows;
    for (const Technique& row : techniques())
        if (row.has_moments() && row.moment_kernel().bits == 16) rows.push_back(&row);
    return rows;
}

float nearest_half(float x) {  // searches all halves, which needs no other definition
    float best = 0;
    for (int exponent = -15; exponent <= 15; ++exponent)
        for (int mantissa = 0; mantissa < 1024; ++mantissa) {
            const float half = exponent == -15
                                   ? std::ldexp(static_cast<float>(mantissa), -24)
                                   : std::ldexp(static_cast<float>(1024 + mantissa), exponent - 10);
            if (std::abs(half - x) < std::abs(best - x)) best = half;
        }
    return best;
}

TEST(Quantisation, StoresMultiplesAndHalves) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> depth(-1, 1);
    for (const Technique* technique : of_16_bits()) {
        for (const float absorbance : {1e-8f, 3e-6f, 5e-5f, 0.004f, 0.1f, 1.3f, 7.7f, 10.0f}) {
            MomentVector stored;
            for (int i = 0; i < 3; ++i) {
                const float before = stored.b0;
                technique->moment_kernel().add_fragment(stored, depth(random), absorbance,
                                                        {.wrapping_zone_angle = 0.3f});
                EXPECT_EQ(stored.b0, nearest_half(before + absorbance)) << technique->id;
                for (int k = 0; k < technique->moment_kernel().moment_floats; ++k) {
                    const float code = std::round(stored.b[static_cast<std::size_t>(k)] * 65535.0f);
                    EXPECT_EQ(stored.b[static_cast<std::size_t>(k)], code / 65535.0f);
                    EXPECT_TRUE(code >= 0 && code <= 65535);
                }
            }
        }
    }
}

// The stored moments of one fragment are accurate to the last bit of 16 bits: half a code in the transformed
// moments, plus the error of float arithmetic with entries up to 127.
TEST(Quantisation, OneFragmentComesBack) {
    for (const Technique* technique : of_16_bits()) {
        double worst = 0;
        for (int step = -1000; step <= 1000; ++step) {
            const float z = static_cast<float>(step) * 1e-3f;
            MomentVector stored;
            technique->moment_kernel().add_fragment(stored, z, 1.0f, {.wrapping_zone_angle = 0.3f});
            EXPECT_EQ(stored.b0, 1.0f);
            const MomentVector back = technique->moment_kernel().moments_of(stored);
            for (int k = 0; k < technique->moment_kernel().moment_floats; ++k) {
                double exact = std::pow(static_cast<double>(z), k + 1);
                if (technique->on_circle()) {
                    const double phase =
                        (static_cast<double>(z) + 1) * (std::numbers::pi - 0.15) * (k / 2 + 1);
                    exact = k % 2 == 0 ? std::cos(phase) : std::sin(phase);
                }
                worst = std::max(worst,
                                 std::abs(static_cast<double>(back.b[static_cast<std::size_t>(k)]) - exact));
            }
        }
        // Rows of the inverses sum to less than 3; 7.6e-6 is half a code.
        EXPECT_LT(worst, 4e-5) << technique->id;
        EXPECT_GT(worst, 3e-6) << technique->id << ": is it rounded at all?";
    }
}

}  // namespace
}  // namespace momentscope::test
