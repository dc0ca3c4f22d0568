// sharp_bounds_test.cpp -- compares sharp bounds with the truth, with Algorithm 1 where it is sharp, too, and
// on the line with linear programs.
#include "core/inspect/sharp_bounds.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/inspect/curve.hpp"
#include "core/inspect/linear_program.hpp"
#include "core/ray/random_ray.hpp"
#include "core/reference/exact_reconstruction.hpp"
#include "core/reference/extended.hpp"
#include "tests/property/moment_rows.hpp"

namespace momentscope::test {
namespace {

using reference::Extended;

const ResolvedParameters PARAMETERS = {.theta = 0.3f};

// Even depths, and the own depth of every fragment.
std::vector<float> depths_of(const ViewRay& ray, std::size_t even) {
    std::vector<float> depths = even_depths(even);
    for (const Fragment& fragment : ray.fragments) depths.push_back(fragment.depth);
    std::ranges::sort(depths);
    return depths;
}

class SharpBoundsOf : public ::testing::TestWithParam<const Technique*> {};

TEST_P(SharpBoundsOf, RandomRaysHoldTheTruth) {
    RandomNumbers random(11);
    for (int count = 1; count <= 12; ++count) {
        const ViewRay ray = random_ray(random, count);
        const std::vector<float> depths = depths_of(ray, 17);
        const auto bounds = sharp_bounds(ray, *GetParam(), PARAMETERS, depths);
        ASSERT_TRUE(bounds) << count << " fragments";
        const double rounding = 1e-6 * total_absorbance(ray);  // the bounds are floats
        for (std::size_t i = 0; i < depths.size(); ++i) {
            double before = 0, until = 0;
            for (const Fragment& fragment : ray.fragments) {
                const double absorbance = static_cast<double>(fragment_absorbance(fragment.opacity));
                if (fragment.depth < depths[i]) before += absorbance;
                if (fragment.depth <= depths[i]) until += absorbance;
            }
            EXPECT_LE(static_cast<double>(bounds->lower[i]), before + rounding);
            EXPECT_GE(static_cast<double>(bounds->upper[i]), until - rounding);
        }
    }
}

// m moments of a basis on the line determine m/2 surfaces; m trigonometric moments determine m.
TEST_P(SharpBoundsOf, FewSurfacesAreTheTruth) {
    const bool circle = GetParam()->on_circle();
    const int most = circle ? GetParam()->moments().moment_count : GetParam()->moments().moment_count / 2;
    ViewRay ray;
    for (int i = 0; i < most; ++i) {
        const float depth = -0.8f + 1.6f * (static_cast<float>(i) + 0.5f) / static_cast<float>(most);
        ray.fragments.push_back({depth, depth, 0.5f});
    }
    const std::vector<float> depths = {-1, -0.75f, -0.1f, 0.05f, 0.75f, 1};
    const auto bounds = sharp_bounds(ray, *GetParam(), PARAMETERS, depths);
    ASSERT_TRUE(bounds);
    const std::vector<double> truth = true_absorbance(ray, depths);
    for (std::size_t i = 0; i < depths.size(); ++i) {
        // The moments are met within 1e-9. This allows some mass, which the distance between the surfaces
        // magnifies.
        EXPECT_NEAR(static_cast<double>(bounds->lower[i]), truth[i], 1e-6) << "at " << depths[i];
        EXPECT_NEAR(static_cast<double>(bounds->upper[i]), truth[i], 1e-6) << "at " << depths[i];
    }
}

INSTANTIATE_TEST_SUITE_P(Techniques, SharpBoundsOf, ::testing::ValuesIn(kernel_techniques()),
                         [](const auto& one) { return test_name(*one.param); });

// Algorithm 1 in exact arithmetic is sharp if its masses lie in the depth range. Otherwise the depth range is
// additional knowledge.
TEST(SharpBounds, AreThoseOfAlgorithm1WhereItsMassesLieInTheDepthRange) {
    using std::pow;
    RandomNumbers random(12);
    const Technique& technique = require_technique("power6-32");
    int compared = 0;
    for (int i = 0; i < 20; ++i) {
        const ViewRay ray = random_ray(random, 6);
        reference::PowerMoments<6, Extended> moments{};
        Extended total = 0;
        for (const Fragment& fragment : ray.fragments) {
            const auto absorbance = static_cast<Extended>(fragment_absorbance(fragment.opacity));
            total += absorbance;
            for (std::size_t k = 0; k < moments.size(); ++k)
                moments[k] += absorbance * pow(static_cast<Extended>(fragment.depth), static_cast<int>(k));
        }
        for (Extended& moment : moments) moment /= total;
        const std::vector<float> depths = even_depths(21);
        const auto sharp = sharp_bounds(ray, technique, PARAMETERS, depths);
        ASSERT_TRUE(sharp);
        for (std::size_t d = 0; d < depths.size(); ++d) {
            const auto exact = reference::power_bounds<6, Extended>(moments, depths[d]);
            ASSERT_TRUE(exact);
            const double lower = static_cast<double>(exact->lower * total);
            const double upper = static_cast<double>(exact->upper * total);
            const double scale = static_cast<double>(total);
            constexpr double ROUNDING = 2e-7;  // the bounds are floats
            EXPECT_GE(static_cast<double>(sharp->lower[d]), lower - ROUNDING * scale);
            EXPECT_LE(static_cast<double>(sharp->upper[d]), upper + ROUNDING * scale);
            const bool inside =
                std::ranges::all_of(exact->depth, [](Extended depth) { return depth >= -1 && depth <= 1; });
            if (!inside) continue;
            ++compared;
            EXPECT_NEAR(static_cast<double>(sharp->lower[d]), lower, ROUNDING * scale);
            EXPECT_NEAR(static_cast<double>(sharp->upper[d]), upper, ROUNDING * scale);
        }
    }
    EXPECT_GT(compared, 100);
}

/// The least share of b_0 in front of `depth`, or the greatest share up to it, with masses at 2001 even
/// depths, at the fragments and at the depth itself.
double bound_on_grid(const ViewRay& ray, int moments, double depth, bool upper) {
    std::vector<double> grid = {depth};
    for (const Fragment& fragment : ray.fragments) grid.push_back(fragment.depth);
    for (int k = 0; k <= 1000; ++k) grid.push_back(-1 + 2e-3 * k);
    const auto column_at = [&](double z) {  // Chebyshev: the same constraints, but better conditioned
        std::vector<double> column;
        for (int j = 0; j <= moments; ++j)
            column.push_back(std::cos(j * std::acos(std::clamp(z, -1.0, 1.0))));
        return column;
    };
    std::vector<double> of_ray(static_cast<std::size_t>(moments) + 1);
    for (const Fragment& fragment : ray.fragments) {
        const std::vector<double> column = column_at(fragment.depth);
        const double share =
            static_cast<double>(fragment_absorbance(fragment.opacity)) / total_absorbance(ray);
        for (std::size_t j = 0; j < column.size(); ++j) of_ray[j] += share * column[j];
    }
    LinearProgram program(of_ray, 1e-9);
    for (const double z : grid) {
        const double cost = upper ? (z <= depth ? -1 : 0) : (z < depth ? 1 : 0);
        program.add_column(column_at(z), cost);
    }
    EXPECT_TRUE(program.primal());
    return upper ? -program.cost() : program.cost();
}

// On a grid, the bounds are narrower, because the nearest possible masses are off by up to 1e-3 of depth,
// which matters where the bounds are steep. They are wider because CLP meets the moments only within 1e-9: by
// 1e-4 if the moments almost determine the truth.
TEST(SharpBounds, OfTheLineAreThoseOfALinearProgram) {
    RandomNumbers random(17);
    double worst = 0;
    for (const char* id : {"power4-32", "power6-32", "power8-32"}) {
        const Technique& technique = require_technique(id);
        for (int i = 0; i < 6; ++i) {
            ViewRay ray = random_ray(random, 5 + i % 5);
            if (i % 3 == 1) ray.fragments[0].depth = -1;  // masses at the ends count, too
            if (i % 3 == 1) ray.fragments[1].depth = 1;
            std::vector<float> depths = {-1, -0.99f, -0.61f, -0.2f, 0.013f, 0.5f, 0.987f, 1};
            depths.push_back(ray.fragments[2].depth);
            const auto sharp = sharp_bounds(ray, technique, PARAMETERS, depths);
            ASSERT_TRUE(sharp);
            const double total = total_absorbance(ray);
            for (std::size_t d = 0; d < depths.size(); ++d) {
                const double lower = bound_on_grid(ray, technique.moments().moment_count, depths[d], false);
                const double upper = bound_on_grid(ray, technique.moments().moment_count, depths[d], true);
                const double low = static_cast<double>(sharp->lower[d]) / total;
                const double high = static_cast<double>(sharp->upper[d]) / total;
                EXPECT_LE(low, lower + 2e-4) << id << " at " << depths[d];
                EXPECT_GE(high, upper - 2e-4) << id << " at " << depths[d];
                worst = std::max({worst, lower - low, high - upper});
            }
        }
    }
    fmt::print("the linear program is narrower by at most {:.1e}\n", worst);
    EXPECT_LT(worst, 2e-3);
}

// The reason for sharp bounds: for trigonometric moments, the results for beta = 0 and beta = 1 are not
// bounds.
TEST(SharpBounds, HoldWhereBetaDoesNot) {
    RandomNumbers random(13);
    const Technique& technique = require_technique("trig2-32");
    const ParameterValues values;
    int outside_beta = 0, outside_sharp = 0;
    for (int i = 0; i < 20; ++i) {
        const ViewRay ray = random_ray(random, 5);
        const std::vector<float> depths = even_depths(33);
        const Curve curve = sample_curve(ray, technique, values, depths);
        const auto sharp = sharp_bounds(ray, technique, curve.parameters, depths);
        ASSERT_TRUE(sharp);
        const auto outside = [&](float low, float high, double truth) {
            const double tolerance = 1e-3 * curve.total_absorbance;
            return truth < static_cast<double>(low) - tolerance ||
                   truth > static_cast<double>(high) + tolerance;
        };
        for (std::size_t d = 0; d < depths.size(); ++d) {
            outside_beta += outside(curve.beta0[d], curve.beta1[d], curve.truth[d]) ? 1 : 0;
            outside_sharp += outside(sharp->lower[d], sharp->upper[d], curve.truth[d]) ? 1 : 0;
        }
    }
    EXPECT_GT(outside_beta, 10) << "then beta would be as good as the linear program";
    EXPECT_EQ(outside_sharp, 0);
}

// The depths of a zoomed plot: their columns are nearly equal, and CLP must not cycle.
TEST(SharpBounds, OfDepthsThatLieCloseAreThereAndHoldTheTruth) {
    RandomNumbers random(16);
    for (int i = 0; i < 60; ++i) {
        const Technique& technique = require_technique(i % 2 == 0 ? "power8-32" : "trig2-32");
        const ViewRay ray = random_ray(random, 1 + i % 7);
        const float width = std::pow(10.0f, static_cast<float>(-(i % 5)));
        std::vector<float> depths;
        for (int k = -30; k <= 30; ++k)
            depths.push_back(
                std::clamp(ray.fragments[0].depth + width * static_cast<float>(k) / 60, -1.0f, 1.0f));
        const auto bounds = sharp_bounds(ray, technique, PARAMETERS, depths);
        ASSERT_TRUE(bounds);
        const std::vector<double> truth = true_absorbance(ray, depths);
        const double rounding = 1e-6 * total_absorbance(ray);
        for (std::size_t k = 0; k < depths.size(); ++k) {
            EXPECT_LE(static_cast<double>(bounds->lower[k]), truth[k] + rounding);
            EXPECT_GE(static_cast<double>(bounds->upper[k]), truth[k] - rounding);
        }
    }
}

TEST(SharpBounds, OfNothingAreEmptyAndStopWhenTold) {
    const std::vector<float> depths = {0};
    const Technique& technique = require_technique("trig3-32");
    const auto nothing = sharp_bounds({}, technique, PARAMETERS, depths);
    ASSERT_TRUE(nothing);
    EXPECT_TRUE(nothing->depth.empty());
    RandomNumbers random(14);
    const ViewRay ray = random_ray(random, 4);
    EXPECT_TRUE(sharp_bounds(ray, require_technique("sorted"), PARAMETERS, depths)->depth.empty());
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(sharp_bounds(ray, technique, PARAMETERS, depths, stop.get_token()));
}

TEST(SharpBounds, OfManyFragmentsHoldTheTruth) {
    RandomNumbers random(15);
    const ViewRay ray = thin_ray(random, 5000);
    const std::vector<float> depths = {-0.5f, 0, 0.5f};
    const std::vector<double> truth = true_absorbance(ray, depths);
    for (const char* id : {"power4-32", "trig2-32"}) {
        const auto bounds = sharp_bounds(ray, require_technique(id), PARAMETERS, depths);
        ASSERT_TRUE(bounds);
        // On the circle, fragments move by half a step of the grid.
        const double slack = (std::string(id) == "trig2-32" ? 1e-3 : 1e-6) * total_absorbance(ray);
        for (std::size_t i = 0; i < depths.size(); ++i) {
            EXPECT_LE(static_cast<double>(bounds->lower[i]), truth[i] + slack);
            EXPECT_GE(static_cast<double>(bounds->upper[i]), truth[i] - slack);
        }
    }
}

}  // namespace
}  // namespace momentscope::test
