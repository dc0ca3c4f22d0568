// opaque_shadow_test.cpp -- compares shadow maps of opaque casters with linear programs (Algorithm 1 of
// Peters and Klein 2015), with Cantelli's inequality and with the mathematics of transparency.
#include "core/shadow/opaque_shadow.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/inspect/linear_program.hpp"
#include "core/ray/random_ray.hpp"
#include "core/techniques/moment_kernel.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope::test {
namespace {

struct Mass {
    double depth, weight;
};

// The depths of a filter region; the weights sum to 1.
std::vector<Mass> random_region(RandomNumbers& random, int count) {
    std::vector<Mass> region;
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        region.push_back(
            {static_cast<double>(random.uniform(-1, 1)), static_cast<double>(random.uniform(0.1f, 1))});
        sum += region.back().weight;
    }
    for (Mass& mass : region) mass.weight /= sum;
    return region;
}

ShadowTexel mean_texel(const OpaqueShadow& row, const std::vector<Mass>& region) {
    std::array<double, 4> sum{};
    for (const Mass& mass : region) {
        const ShadowTexel texel = row.texel(static_cast<float>(mass.depth));
        for (std::size_t k = 0; k < 4; ++k) sum[k] += mass.weight * static_cast<double>(texel[k]);
    }
    ShadowTexel mean;
    for (std::size_t k = 0; k < 4; ++k) mean[k] = static_cast<float>(sum[k]);
    return mean;
}

double in_front(const std::vector<Mass>& region, double depth) {
    double sum = 0;
    for (const Mass& mass : region)
        if (mass.depth < depth) sum += mass.weight;
    return sum;
}

/// The least mass in front of `depth` over all distributions on `grid` with the region's moments 0 to 4.
/// Columns are divided by 1 + z^4, so that far masses do not give larger numbers than near ones.
double least_in_front(const std::vector<Mass>& region, double depth, std::vector<double> grid) {
    grid.push_back(depth);
    for (const Mass& mass : region)
        grid.push_back(mass.depth);  // otherwise no mixture of the grid may have the moments
    constexpr double BIAS = 3e-7, TOWARDS[] = {1, 0, 0.375, 0, 0.375};
    std::array<double, 5> moments{};
    for (std::size_t j = 0; j < 5; ++j) {
        moments[j] = BIAS * TOWARDS[j];
        for (const Mass& mass : region)
            moments[j] += (1 - BIAS) * mass.weight * std::pow(mass.depth, static_cast<int>(j));
    }
    LinearProgram program(moments, 1e-9);
    for (const double z : grid) {
        const double size = 1 + z * z * z * z;
        std::array<double, 5> column{};
        for (std::size_t j = 0; j < 5; ++j) column[j] = std::pow(z, static_cast<int>(j)) / size;
        program.add_column(column, z < depth ? 1 / size : 0);
    }
    EXPECT_TRUE(program.primal());
    return program.cost();
}

// 2001 depths of the depth range.
std::vector<double> range_grid() {
    std::vector<double> grid;
    for (int k = 0; k <= 2000; ++k) grid.push_back(-1 + k * 1e-3);
    return grid;
}

// The same depths, and increasingly coarse ones up to 200 beyond the range. A mass at distance d can weigh at
// most d^-4.
std::vector<double> line_grid() {
    std::vector<double> grid = range_grid();
    for (double z = 1; z < 200; z *= 1.006) {
        grid.push_back(z);
        grid.push_back(-z);
    }
    return grid;
}

// The grid's step is 1e-3. Near a support point, the objective is quadratic in the distance to it, and bias
// adds 3e-7. The measured maximum is 4e-4.
void expect_sharp(const char* id, const std::vector<double>& grid) {
    const OpaqueShadow& row = require_opaque_shadow(id);
    RandomNumbers random(5);
    double worst = 0;
    for (int i = 0; i < 120; ++i) {
        const std::vector<Mass> region = random_region(random, 3 + i % 6);
        const float depth = random.uniform(-0.95f, 0.95f);
        const double least = least_in_front(region, static_cast<double>(depth), grid);
        const auto shadowed = static_cast<double>(row.shadowed(mean_texel(row, region), depth));
        EXPECT_NEAR(shadowed, least, 1e-3) << "at " << depth << " of region " << i;
        worst = std::max(worst, std::abs(shadowed - least));
    }
    std::printf("%s: off by %.1e at most\n", id, worst);
}

TEST(OpaqueShadow, HamburgerIsTheSharpBoundOnTheLine) {
    expect_sharp("hamburger-32", line_grid());
}

TEST(OpaqueShadow, HausdorffIsTheSharpBoundWithinTheRange) {
    expect_sharp("hausdorff", range_grid());
}

TEST(OpaqueShadow, HausdorffIsNeverLighterThanHamburger) {
    const OpaqueShadow &line = require_opaque_shadow("hamburger-32"),
                       &range = require_opaque_shadow("hausdorff");
    RandomNumbers random(6);
    int darker = 0;
    for (int i = 0; i < 50'000; ++i) {
        const ShadowTexel texel = mean_texel(line, random_region(random, 1 + i % 12));
        const float depth = random.uniform(-1, 1);
        const float on_line = line.shadowed(texel, depth), within = range.shadowed(texel, depth);
        ASSERT_GE(within, on_line) << "region " << i;
        ASSERT_LE(within, 1.0f);
        darker += within > on_line + 0.01f ? 1 : 0;
    }
    EXPECT_GT(darker, 5'000) << "else it knows nothing of the range";
}

// Moment bounds are lower bounds of the shadow of the biased region. Bias moves 3e-7 of its mass, and
// rounding is magnified if few surfaces leave the matrix nearly singular.
TEST(OpaqueShadow, MomentBoundsAreNotTooDark) {
    for (const char* id : {"hamburger-32", "hausdorff"}) {
        const OpaqueShadow& row = require_opaque_shadow(id);
        RandomNumbers random(7);
        for (int i = 0; i < 20'000; ++i) {
            const std::vector<Mass> region = random_region(random, 3 + i % 10);
            const float depth = random.uniform(-1, 1);
            ASSERT_LE(static_cast<double>(row.shadowed(mean_texel(row, region), depth)),
                      in_front(region, static_cast<double>(depth)) + 2e-3)
                << id << ", region " << i;
        }
    }
}

// Cantelli: at or behind the mean, the lit fraction of a receiver is never below the true one. In front of
// the mean everything is lit.
TEST(OpaqueShadow, VarianceIsNeverTooDark) {
    const OpaqueShadow& row = require_opaque_shadow("variance");
    RandomNumbers random(8);
    int leaks = 0;
    for (int i = 0; i < 100'000; ++i) {
        const std::vector<Mass> region = random_region(random, 1 + i % 12);
        const ShadowTexel texel = mean_texel(row, region);
        const float depth = random.uniform(-1, 1);
        const auto shadowed = static_cast<double>(row.shadowed(texel, depth));
        ASSERT_LE(shadowed, in_front(region, static_cast<double>(depth)) + 1e-5) << "region " << i;
        if (depth < texel[0]) {
            ASSERT_EQ(shadowed, 0.0);
        }
        leaks += shadowed < in_front(region, static_cast<double>(depth)) - 0.1 ? 1 : 0;
    }
    EXPECT_GT(leaks, 10'000) << "the bound is as loose as it is known to be";
}

// The same solver with b_0 = 1 and beta = 0 gives the same bits.
TEST(OpaqueShadow, MomentsAreThoseOfTransparency) {
    const struct {
        const char *map, *technique;
        float bias, theta;
    } rows[] = {{"hamburger-32", "power4-32", 3e-7f, 0}, {"trigonometric", "trig2-32", 4e-7f, 0.314159265f}};
    for (const auto& [map, id, bias, theta] : rows) {
        const OpaqueShadow& row = require_opaque_shadow(map);
        const MomentKernel& kernel = require_technique(id).moment_kernel();
        RandomNumbers random(9);
        for (int i = 0; i < 1000; ++i) {
            const ShadowTexel texel = mean_texel(row, random_region(random, 1 + i % 9));
            MomentVector moments;
            moments.b0 = 1;
            std::ranges::copy(texel, moments.b.begin());
            const float depth = random.uniform(-1, 1);
            float reconstructed = 0, beta0 = 0, beta1 = 0;
            const ReconstructionSettings settings = {
                .overestimation = 0, .wrapping_zone_angle = theta, .bias = bias};
            kernel.evaluate(moments, settings, {&depth, 1}, {{&reconstructed, 1}, {&beta0, 1}, {&beta1, 1}});
            ASSERT_EQ(row.shadowed(texel, depth), reconstructed) << map;
        }
    }
}

// 16 bits have a greater bias and the rounding of the transform, which is the reason for Table 1's alpha of
// 6e-5.
TEST(OpaqueShadow, SixteenBitsAreCloseToFloats) {
    const OpaqueShadow &floats = require_opaque_shadow("hamburger-32"),
                       &bits = require_opaque_shadow("hamburger-16");
    RandomNumbers random(10);
    double sum = 0;
    for (int i = 0; i < 10'000; ++i) {
        const std::vector<Mass> region = random_region(random, 3 + i % 9);
        const float depth = random.uniform(-1, 1);
        ShadowTexel stored = mean_texel(bits, region);
        for (float& number : stored) {
            ASSERT_GE(number, -1e-6f);
            ASSERT_LE(number, 1 + 1e-6f);
            number = std::round(65535 * number) / 65535;
        }
        const float off = bits.shadowed(stored, depth) - floats.shadowed(mean_texel(floats, region), depth);
        sum += static_cast<double>(std::abs(off));
    }
    std::printf("16 bits: off from floats by %.1e on average\n", sum / 10'000);
    EXPECT_LT(sum / 10'000, 1.5e-3);
    EXPECT_GT(sum / 10'000, 1e-5) << "else nothing was rounded";
}

TEST(OpaqueShadow, ComparingDepthsIsExactBeyondTheSlack) {
    const OpaqueShadow& row = require_opaque_shadow("pcf");
    EXPECT_TRUE(row.unfiltered);
    EXPECT_EQ(row.shadowed(row.texel(0.2f), 0.3f), 1.0f);
    EXPECT_EQ(row.shadowed(row.texel(0.2f), 0.205f), 0.0f);
    EXPECT_EQ(row.shadowed(row.texel(0.2f), 0.1f), 0.0f);
}

}  // namespace
}  // namespace momentscope::test
