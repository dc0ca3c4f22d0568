// view_ray_test.cpp -- the true absorbance along a ray, its order and its depths, against sums by hand.
#include "core/ray/view_ray.hpp"

#include <gtest/gtest.h>
#include <array>
#include <cmath>
#include <vector>

using namespace momentscope;

namespace {

ViewRay ray_of(std::initializer_list<std::pair<float, float>> depths_and_opacities) {
    ViewRay ray;
    for (const auto& [depth, opacity] : depths_and_opacities) {
        Fragment fragment;
        fragment.depth = fragment.view_depth = depth;
        fragment.opacity = opacity;
        ray.fragments.push_back(fragment);
    }
    return ray;
}

std::vector<double> truth(const ViewRay& ray, std::vector<float> depths) {
    return true_absorbance(ray, depths);
}

// The absorbances of opacities one half and three quarters: ln 2 and 2 ln 2. As floats they are accurate to 3
// ulps of at most 1.4, 3.6e-7 each, so sums of a few stay below 2e-6.
const double LN2 = std::log(2.0);
constexpr double FLOAT_NOISE = 2e-6;

TEST(TrueAbsorbance, ClimbsByEachFragmentBehindItsDepth) {
    const ViewRay ray = ray_of({{0.5f, 0.75f}, {-0.5f, 0.5f}});  // submitted back to front
    const auto at = truth(ray, {-1.0f, 0.0f, 1.0f});
    ASSERT_EQ(at.size(), 3u);
    EXPECT_EQ(at[0], 0.0);
    EXPECT_NEAR(at[1], LN2, FLOAT_NOISE);
    EXPECT_NEAR(at[2], 3 * LN2, FLOAT_NOISE);
    EXPECT_NEAR(total_absorbance(ray), 3 * LN2, FLOAT_NOISE);
}

TEST(TrueAbsorbance, CountsNoFragmentAtItsOwnDepth) {
    const ViewRay ray = ray_of({{0.25f, 0.5f}});
    const auto at = truth(ray, {std::nextafter(0.25f, -1.0f), 0.25f, std::nextafter(0.25f, 1.0f)});
    EXPECT_EQ(at[0], 0.0);
    EXPECT_EQ(at[1], 0.0);
    EXPECT_NEAR(at[2], LN2, FLOAT_NOISE);
    const ViewRay ends = ray_of({{-1.0f, 0.5f}, {1.0f, 0.5f}});
    EXPECT_EQ(truth(ends, {-1.0f})[0], 0.0);
    EXPECT_NEAR(truth(ends, {1.0f})[0], LN2,
                FLOAT_NOISE);  // the fragment at the far end hides nothing in the range
}

TEST(TrueAbsorbance, OfATieCountsNoneOfItAtItsDepthAndAllBehind) {
    const ViewRay ray = ray_of({{0.0f, 0.5f}, {-0.5f, 0.75f}, {0.0f, 0.75f}, {0.0f, 0.5f}});
    const auto at = truth(ray, {0.0f, 1e-30f});
    EXPECT_NEAR(at[0], 2 * LN2, FLOAT_NOISE);
    EXPECT_NEAR(at[1], 6 * LN2, FLOAT_NOISE);
}

TEST(TrueAbsorbance, TakesDepthsInAnyOrderAndNoneAtAll) {
    const ViewRay ray = ray_of({{-0.5f, 0.5f}, {0.5f, 0.5f}});
    const auto at = truth(ray, {1.0f, -1.0f, 0.0f, 1.0f});
    EXPECT_EQ(at[0], at[3]);
    EXPECT_EQ(at[1], 0.0);
    EXPECT_NEAR(at[2], LN2, FLOAT_NOISE);
    EXPECT_TRUE(truth(ray, {}).empty());
    EXPECT_EQ(truth(ViewRay(), {-1.0f, 1.0f}), (std::vector<double>{0.0, 0.0}));
    EXPECT_EQ(total_absorbance(ViewRay()), 0.0);
}

TEST(TrueAbsorbance, OfManyFaintFragmentsLosesNone) {
    ViewRay ray;
    for (int i = 0; i < 100'000; ++i) {
        Fragment fragment;
        fragment.opacity = 1.0f / 255.0f;
        ray.fragments.push_back(fragment);
    }
    const double exact = -100'000 * std::log1p(-1.0 / 255.0);
    // In double, the error is that of one absorbance, below an ulp of a float (measured 0.05). A float sum
    // would be off by 1e-3.
    EXPECT_NEAR(total_absorbance(ray) / exact, 1.0, 1.2e-7);
    EXPECT_NEAR(truth(ray, {1.0f})[0] / exact, 1.0, 1.2e-7);
}

TEST(FragmentAbsorbance, IsThatOfTheShadersCap) {
    EXPECT_EQ(fragment_absorbance(0.0f), 0.0f);
    EXPECT_NEAR(fragment_absorbance(0.5f), std::log(2.0f), 1.8e-7f);  // 3 ulps
    EXPECT_LE(fragment_absorbance(1.0f), 10.0f);
    EXPECT_GT(fragment_absorbance(1.0f), 9.99f);
    const ViewRay opaque = ray_of({{0.0f, 1.0f}, {0.5f, 1.0f}});
    EXPECT_EQ(total_absorbance(opaque), 2 * static_cast<double>(fragment_absorbance(1.0f)));
}

TEST(FrontToBack, SortsByDepthAndPutsTheLaterOfATieInFront) {
    const ViewRay ray = ray_of({{0.5f, 0}, {0.0f, 0}, {-0.5f, 0}, {0.0f, 0}, {0.5f, 0}, {0.0f, 0}});
    EXPECT_EQ(front_to_back(ray), (std::vector<std::size_t>{2, 5, 3, 1, 4, 0}));
    EXPECT_TRUE(front_to_back(ViewRay()).empty());
}

TEST(FrontToBack, SortsWhatTheWarpClampedByViewDepth) {
    ViewRay ray = ray_of({{1.0f, 0}, {1.0f, 0}, {1.0f, 0}});
    ray.fragments[0].view_depth = 30.0f;
    ray.fragments[1].view_depth = 20.0f;
    ray.fragments[2].view_depth = 25.0f;
    EXPECT_EQ(front_to_back(ray), (std::vector<std::size_t>{1, 2, 0}));
}

TEST(ToDepth, WithoutAWarpClampsOnly) {
    const DepthWarp none;
    EXPECT_EQ(to_depth(0.3f, none), 0.3f);
    EXPECT_EQ(to_depth(-2.0f, none), -1.0f);
    EXPECT_EQ(to_depth(2.0f, none), 1.0f);
    EXPECT_EQ(to_view_depth(0.3f, none), 0.3f);
}

TEST(ToDepth, WithALogarithmicWarpPutsTheGeometricMeanInTheMiddle) {
    const DepthWarp warp = {DepthWarp::Kind::logarithmic, 1.0f, 16.0f};
    EXPECT_EQ(to_depth(1.0f, warp), -1.0f);
    // A few roundings of numbers up to 2 (ln 16 is 2.8, its half 1.4): 4 of 1.2e-7.
    EXPECT_NEAR(to_depth(2.0f, warp), -0.5f, 5e-7f);
    EXPECT_NEAR(to_depth(4.0f, warp), 0.0f, 5e-7f);
    EXPECT_NEAR(to_depth(16.0f, warp), 1.0f, 5e-7f);
    EXPECT_NEAR(to_view_depth(0.5f, warp), 8.0f,
                8.0f * 1e-6f);  // 5e-7 of depth times half of ln 16, and 2 ulps
    const glm::vec3 factors = depth_warp_factors(warp);
    EXPECT_EQ(factors.x, 0.0f);
    EXPECT_NEAR(factors.y, 2.0f / std::log(16.0f), 3e-7f);
}

}  // namespace
