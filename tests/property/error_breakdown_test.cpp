// error_breakdown_test.cpp -- the shares of a breakdown sum to the error, and on rays with one known fault,
// this fault is named.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/inspect/drawn_fragments.hpp"
#include "core/inspect/error_breakdown.hpp"
#include "core/inspect/pixel_color.hpp"
#include "core/ray/random_ray.hpp"

namespace momentscope::test {
namespace {

const glm::vec3 BEHIND(0.3f, 0.4f, 0.5f);

std::string named(const ErrorBreakdown& breakdown) {
    return std::ranges::max_element(breakdown.contributions, {}, &Contribution::share)->cause;
}

ViewRay sheets(std::initializer_list<float> depths, float opacity = 0.5f) {
    ViewRay ray;
    for (const float depth : depths)
        ray.fragments.push_back(plain_fragment(depth, opacity, ray.fragments.size()));
    return ray;
}

TEST(ErrorBreakdownTest, SharesSumToTheError) {
    RandomNumbers random(41);
    int blamed = 0;
    for (const Technique& technique : techniques()) {
        if (technique.is_truth()) continue;
        SCOPED_TRACE(technique.id);
        for (int i = 0; i < 20; ++i) {
            const ViewRay ray = random_ray(random, 1 + i % 9);
            const ErrorBreakdown breakdown = pixel_error_breakdown(ray, technique, {}, BEHIND);
            double sum = 0;
            for (const Contribution& one : breakdown.contributions) sum += one.share;
            EXPECT_NEAR(sum, breakdown.error,
                        2e-5);  // the last colour of the chain and the shown colour are computed separately
            blamed += breakdown.contributions.back().cause == "renormalisation" ? 1 : 0;
            EXPECT_FALSE(breakdown.sentence.empty());
        }
    }
    EXPECT_GT(blamed, 5) << "sometimes a pixel is better without";
    EXPECT_LT(blamed, 200) << "but not often";
}

TEST(ErrorBreakdownTest, NamesTheFault) {
    const auto of = [](const ViewRay& ray, const char* technique, const ParameterValues& values = {}) {
        return named(pixel_error_breakdown(ray, require_technique(technique), values, BEHIND));
    };
    using enum ParameterId;
    const ViewRay two = sheets({-0.5f, 0.5f}), five = sheets({-0.8f, -0.4f, 0.0f, 0.4f, 0.8f});
    EXPECT_EQ(of(five, "power4-32", values_with({{beta, 0}})),
              "the moment count (4 power moments for 5 fragments)");
    EXPECT_EQ(of(two, "power6-32", values_with({{alpha, 0.1f}, {beta, 0}})), "the moment bias");
    EXPECT_EQ(of(two, "power6-32", values_with({{beta, 1}, {renormalize, 0}})), "self-occlusion")
        << "the moments determine two surfaces, so each of them can only occlude itself";
    EXPECT_EQ(of(five, "power4-32", values_with({{beta, 1}, {estimate, 1}, {renormalize, 0}})),
              "the overestimation weight");
    EXPECT_EQ(of(two, "cheb6-32", values_with({{alpha, 0.1f}, {beta, 0}})), "the moment bias");
    const ViewRay six = sheets({-0.8f, -0.5f, -0.2f, 0.1f, 0.4f, 0.7f});
    EXPECT_EQ(of(six, "trig3-32", values_with({{theta, 3.1f}, {beta, 0}, {renormalize, 0}})),
              "the wrapping zone");
    EXPECT_EQ(of(two, "power8-16", values_with({{alpha, 1e-6f}, {beta, 0}})), "16-bit drift of the moments");
    EXPECT_EQ(of(two, "unsorted"), "the order of submission") << "front first, so that the last lies on top";
    EXPECT_EQ(of(five, "wboit"), "the method's own approximation");
    EXPECT_EQ(of(two, "mlab", values_with({{layer_bits, 1}})), "rounding to few bits");
    ViewRay mixed = two;
    mixed.low_resolution_sources = {{0.5f, two.fragments}, {0.5f, sheets({-0.9f, -0.7f}, 0.9f).fragments}};
    EXPECT_EQ(of(mixed, "mt", values_with({{resolution, 1}})), "the low resolution of the moments");
}

// Two panes at the same depth: no technique with moments knows which one is in front.
TEST(ErrorBreakdownTest, TiesAreBlamedOnTies) {
    ViewRay ray = sheets({0.2f, 0.2f});
    ray.fragments[0].color = {1, 0, 0};
    ray.fragments[1].color = {0, 0, 1};
    for (const char* technique : {"power8-32", "cheb8-32", "trig4-32", "wavelet", "mt"})
        EXPECT_EQ(named(pixel_error_breakdown(ray, require_technique(technique), {}, BEHIND)),
                  "surfaces at the same depth")
            << technique;
    const ViewRay five = sheets({-0.8f, -0.4f, 0.0f, 0.4f, 0.8f});
    EXPECT_EQ(named(pixel_error_breakdown(five, require_technique("cheb4-32"),
                                          values_with({{ParameterId::beta, 0}}), BEHIND)),
              "the moment count (4 Chebyshev moments for 5 fragments)");
}

// A surface at an end of the depth range is exact, and a fragment behind it does not count as a rounding
// error.
TEST(ErrorBreakdownTest, AnEdgeIsNoFault) {
    const ViewRay ray = sheets({-1.0f, 0.3f});
    for (const char* technique : {"trig2-32", "trig3-32", "trig4-32"})
        EXPECT_LT(pixel_error_breakdown(ray, require_technique(technique),
                                        values_with({{ParameterId::beta, 0}}), BEHIND)
                      .error,
                  0.02)
            << technique;
}

// A lost fragment is missing from the picture, the curve and the history, and the sentence says so.
TEST(ErrorBreakdownTest, PeelingLosesTies) {
    ViewRay ray = sheets({0.2f, 0.2f, -0.4f});
    ray.fragments[1].color = {0, 0, 1};
    const Technique& peeling = require_technique("peeling");
    const std::vector<float> behind_all = {0.9f};
    const Curve curve = sample_curve(ray, peeling, {}, behind_all);
    EXPECT_NEAR(curve.truth[0], 3 * std::log(2.0), 1e-6);
    EXPECT_NEAR(curve.reconstructed[0], 2 * std::log(2.0), 1e-6);
    const auto history = pixel_history(ray, {}, peeling, {});
    EXPECT_EQ(std::ranges::count(history, glm::vec4(0), &PixelHistoryRow::source), 1);
    const PixelColors colors = pixel_colors(ray, history, peeling, {}, BEHIND);
    ViewRay first = ray;
    first.fragments.erase(first.fragments.begin() + 1);
    EXPECT_EQ(colors.technique, pixel_colors(first, {}, peeling, {}, BEHIND).truth);
    const ErrorBreakdown breakdown = pixel_error_breakdown(ray, peeling, {}, BEHIND);
    EXPECT_NEAR(breakdown.error, glm::length(glm::dvec3(colors.technique - colors.truth)), 1e-6);
    EXPECT_NE(breakdown.sentence.find("1 of 3 fragments is lost"), std::string::npos) << breakdown.sentence;
}

// Far away, the depth buffer has the same number for two view depths.
TEST(ErrorBreakdownTest, PeelingComparesWindowDepths) {
    ViewRay ray;
    ray.warp = {DepthWarp::Kind::logarithmic, 1, 1000};
    for (const float view_depth : {900.0f, 900.1f})
        ray.fragments.push_back(
            {.depth = to_depth(view_depth, ray.warp), .view_depth = view_depth, .opacity = 0.5f});
    const Technique& peeling = require_technique("peeling");
    EXPECT_EQ(drawn_fragments(ray, peeling).fragments.size(), 2u) << "near and far planes are unknown";
    ray.near_plane = 0.05f;
    ray.far_plane = 1000;
    EXPECT_EQ(drawn_fragments(ray, peeling).fragments.size(), 1u);
    ray.fragments[1].view_depth = 950;
    EXPECT_EQ(drawn_fragments(ray, peeling).fragments.size(), 2u);
}

// Half floats above 2048 are 2 apart, so adding 0.7 has no effect.
TEST(ErrorBreakdownTest, SaysWhatSixteenBitsLose) {
    ViewRay ray;
    for (int i = 0; i < 50; ++i) ray.fragments.push_back(plain_fragment(0.1f, 0.99995f, 0));
    const auto sentence = [&](const char* technique) {
        return pixel_error_breakdown(ray, require_technique(technique), {}, BEHIND).sentence;
    };
    EXPECT_EQ(sentence("power4-16").find("b₀ ="), std::string::npos) << "500 in steps of 10 is fine";
    for (int i = 0; i < 5000; ++i) ray.fragments.push_back(plain_fragment(0.1f, 0.5f, 0));
    EXPECT_NE(sentence("power4-16").find("b₀ ="), std::string::npos);
    EXPECT_EQ(sentence("power4-32").find("b₀ ="), std::string::npos);
}

TEST(ErrorBreakdownTest, SaysWhenThereIsNothingToSay) {
    const auto sentence = [](const ViewRay& ray, const char* technique) {
        return pixel_error_breakdown(ray, require_technique(technique), {}, BEHIND).sentence;
    };
    EXPECT_NE(sentence(sheets({0.1f}), "wboit").find("Right to"), std::string::npos);
    EXPECT_NE(sentence({}, "wboit").find("Nothing here is transparent"), std::string::npos);
    EXPECT_NE(sentence(sheets({0.1f}), "sorted").find("is the truth"), std::string::npos);
    ViewRay many;
    for (int i = 0; i < 1001; ++i) many.fragments.push_back(plain_fragment(0, 0.01f, 0));
    EXPECT_NE(sentence(many, "power4-32").find("1000"), std::string::npos);
}

}  // namespace
}  // namespace momentscope::test
