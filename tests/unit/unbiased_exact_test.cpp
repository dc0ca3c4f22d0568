// unbiased_exact_test.cpp -- the unbiased exact curve, and the canonical representation of the plot.
#include "core/inspect/exact_estimates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/inspect/canonical.hpp"
#include "core/inspect/pixel_history.hpp"
#include "tests/property/random_rays.hpp"

namespace momentscope::test {
namespace {

ViewRay ray_of(std::initializer_list<std::pair<float, float>> fragments) {
    ViewRay ray;
    for (const auto& [depth, opacity] : fragments) ray.fragments.push_back({depth, depth, opacity});
    return ray;
}

ResolvedParameters without_bias(float beta, float theta = 0.3f) {
    return {.beta = beta, .theta = theta, .alpha = 0};
}

// m power moments determine m/2 surfaces, m trigonometric ones m. Then the unbiased exact curve is the truth.
TEST(UnbiasedExact, IsTheTruthWhereMomentsDetermineIt) {
    const ViewRay two = ray_of({{-0.25f, 0.5f}, {0.5f, 0.75f}});
    const float depths[] = {-1, -0.5f, 0, 0.499f, 0.501f, 1};
    const auto truth = true_absorbance(two, depths);
    for (const Technique& technique : techniques()) {
        if (!technique.has_moments()) continue;
        const auto unbiased_exact = unbiased_absorbance(two, technique, without_bias(0.25f), depths);
        for (std::size_t i = 0; i < unbiased_exact.size(); ++i)
            EXPECT_NEAR(static_cast<double>(unbiased_exact[i]), truth[i], 1e-6)
                << technique.id << " at " << depths[i];
    }
}

TEST(UnbiasedExact, CountsBetaOfAMassAtItsOwnDepth) {
    const ViewRay one = ray_of({{0.25f, 0.5f}});
    const float at[] = {0.25f};
    const Technique& technique = require_technique("power6-32");
    for (const float beta : {0.0f, 0.25f, 1.0f})
        EXPECT_NEAR(static_cast<double>(unbiased_absorbance(one, technique, without_bias(beta), at)[0]),
                    static_cast<double>(beta) * std::log(2.0), 1e-6);
}

TEST(UnbiasedExact, IsEmptyWithoutMomentsAndZeroWithoutFragments) {
    const float at[] = {0, 0.5f};
    EXPECT_TRUE(
        unbiased_absorbance(ray_of({}), require_technique("sorted"), without_bias(0.25f), at).empty());
    EXPECT_EQ(unbiased_absorbance(ray_of({}), require_technique("trig2-32"), without_bias(0.25f), at),
              (std::vector<float>{0, 0}));
}

// With a bias so large that floats do not matter, kernel and reference agree if both use the same bias. The
// unbiased exact curve is this reference with a bias of 0, and a small bias approaches it.
TEST(UnbiasedExact, IsWhatSmallBiasApproaches) {
    std::mt19937 random(5);
    const float depths[] = {-0.9f, -0.3f, 0.1f, 0.7f};
    for (const char* id : {"power4-32", "trig2-32"}) {
        const Technique& technique = require_technique(id);
        double mean = 0;
        constexpr int RAYS = 300;
        for (int i = 0; i < RAYS; ++i) {
            ViewRay ray;
            while (ray.fragments.size() < 6) ray = random_ray(random);
            ParameterValues values;
            const Curve curve = sample_curve(ray, technique, values, depths);
            const auto unbiased_exact = unbiased_absorbance(ray, technique, curve.parameters, depths);
            for (std::size_t d = 0; d < unbiased_exact.size(); ++d)
                mean += std::abs(static_cast<double>(unbiased_exact[d] - curve.reconstructed[d])) /
                        curve.total_absorbance;
        }
        // The bias of Table 1, at most 5e-7 here, moves rays of six and more fragments by this little on
        // average.
        EXPECT_LT(mean / (RAYS * 4), 5e-3) << id;
    }
}

// The masses in the plot have the biased moments of the ray, which are recomputed here from depths and
// weights alone.
TEST(CanonicalRepresentation, HasTheBiasedPowerMoments) {
    std::mt19937 random(6);
    constexpr double B4[] = {0, 0.375, 0, 0.375};  // b* of Table 1
    for (int i = 0; i < 200; ++i) {
        ViewRay ray;
        while (ray.fragments.size() < 4) ray = random_ray(random);
        const float query[] = {0.2f};
        const Curve curve = sample_curve(ray, require_technique("power4-32"), {}, query);
        const CanonicalRepresentation canonical = canonical_representation(curve, query[0]);
        const double b0 = static_cast<double>(curve.moments.b0);
        for (int k = 0; k <= 4; ++k) {
            double sum = static_cast<double>(canonical.query_absorbance) * std::pow(0.2, k);
            for (const PointMass& node : canonical.nodes)
                sum += static_cast<double>(node.absorbance) * std::pow(static_cast<double>(node.depth), k);
            const double alpha = 5e-7;
            const double stored =
                k == 0 ? b0 : static_cast<double>(curve.moments.b[static_cast<std::size_t>(k - 1)]);
            const double biased = k == 0 ? b0 : (1 - alpha) * stored + alpha * b0 * B4[k - 1];
            // Far nodes with tiny masses dominate the fourth moment, so their rounding shows most there.
            EXPECT_NEAR(sum, biased, 2e-3 * b0) << "moment " << k;
        }
    }
}

TEST(CanonicalRepresentation, OfTwoSheetsIsTheTwoSheets) {
    const ViewRay two = ray_of({{-0.25f, 0.5f}, {0.5f, 0.75f}});
    for (const char* id : {"power4-32", "trig2-32"}) {
        const float query[] = {0.0f};
        const Curve curve = sample_curve(two, require_technique(id), {}, query);
        const CanonicalRepresentation canonical = canonical_representation(curve, 0);
        EXPECT_LT(canonical.query_absorbance, 0.01f) << id;
        ASSERT_EQ(canonical.nodes.size(), 2u);
        EXPECT_NEAR(canonical.nodes[0].depth, -0.25f, 0.01f) << id;
        EXPECT_NEAR(canonical.nodes[1].depth, 0.5f, 0.01f) << id;
        EXPECT_NEAR(canonical.nodes[0].absorbance, std::log(2.0f), 0.01f) << id;
        EXPECT_EQ(canonical.nodes[0].value, 1) << "in front of the query";
        EXPECT_EQ(canonical.nodes[1].value, 0) << "behind it";
    }
    EXPECT_NEAR(end_of_circle(0), 1, 1e-6);
    EXPECT_NEAR(end_of_circle(std::numbers::pi_v<float>), 3, 1e-6);
}

TEST(PixelHistory, FollowsCompositingByHand) {
    ViewRay ray = ray_of({{0.5f, 0.75f}, {-0.25f, 0.5f}});  // submitted back to front
    ray.fragments[0].color = {1, 0.5f, 0};
    ray.fragments[1].color = {0, 0, 1};
    const auto rows = pixel_history(ray, {}, require_technique("sorted"), {});
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].fragment, 1u) << "the nearer one first";
    EXPECT_NEAR(rows[0].true_transmittance, 1, 1e-7);
    EXPECT_NEAR(rows[1].true_transmittance, 0.5, 1e-7);
    EXPECT_NEAR(rows[1].error(), 0, 1e-6);
    EXPECT_FALSE(rows[0].gl_transmittance);
    // 0.5 of the light is left, and the opacity is 0.75.
    EXPECT_NEAR(rows[1].source.r, 0.375f, 1e-6f);
    EXPECT_NEAR(rows[1].source.g, 0.1875f, 1e-6f);
    EXPECT_NEAR(rows[1].source.a, 0.375f, 1e-6f);
    EXPECT_EQ(rows[1].sum, glm::vec4(0)) << "it was submitted first";
    EXPECT_NEAR(rows[0].sum.r, 0.375f, 1e-6f);
    const std::string csv = pixel_history_to_csv(ray, rows);
    EXPECT_EQ(std::ranges::count(csv, '\n'), 3);
}

}  // namespace
}  // namespace momentscope::test
