// verdict_test.cpp -- shares of a verdict sum to the error, and on rays with one known fault it is the one
// that is named.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/inspect/verdict.hpp"
#include "core/ray/random_ray.hpp"

namespace momentscope::test {
namespace {

const glm::vec3 BEHIND(0.3f, 0.4f, 0.5f);

std::string named(const Verdict& verdict) {
    return std::ranges::max_element(verdict.contributions, {}, &Contribution::share)->cause;
}

ViewRay sheets(std::initializer_list<float> depths, float opacity = 0.5f) {
    ViewRay ray;
    for (const float depth : depths)
        ray.fragments.push_back(plain_fragment(depth, opacity, ray.fragments.size()));
    return ray;
}

TEST(VerdictTest, SharesSumToTheError) {
    RandomNumbers random(41);
    int blamed = 0;
    for (const Technique& technique : techniques()) {
        if (technique.is_truth()) continue;
        SCOPED_TRACE(technique.id);
        for (int i = 0; i < 20; ++i) {
            const ViewRay ray = random_ray(random, 1 + i % 9);
            const Verdict verdict = pixel_verdict(ray, technique, {}, BEHIND);
            double sum = 0;
            for (const Contribution& one : verdict.contributions) sum += one.share;
            EXPECT_NEAR(sum, verdict.error,
                        2e-5);  // the last colour of the chain is computed apart from the shown one
            blamed += verdict.contributions.back().cause == "renormalisation" ? 1 : 0;
            EXPECT_FALSE(verdict.sentence.empty());
        }
    }
    EXPECT_GT(blamed, 5) << "sometimes a pixel is better without";
    EXPECT_LT(blamed, 200) << "but not often";
}

TEST(VerdictTest, NamesTheFault) {
    const auto of = [](const ViewRay& ray, const char* technique, const ParameterValues& values = {}) {
        return named(pixel_verdict(ray, require_technique(technique), values, BEHIND));
    };
    using enum ParameterId;
    const ViewRay two = sheets({-0.5f, 0.5f}), five = sheets({-0.8f, -0.4f, 0.0f, 0.4f, 0.8f});
    EXPECT_EQ(of(five, "power4-32", values_with({{beta, 0}})),
              "the moment count (4 power moments for 5 fragments)");
    EXPECT_EQ(of(two, "power6-32", values_with({{alpha, 0.1f}, {beta, 0}})), "the moment bias");
    EXPECT_EQ(of(two, "power6-32", values_with({{beta, 1}, {renormalize, 0}})), "the overestimation weight");
    EXPECT_EQ(of(two, "cheb6-32", values_with({{alpha, 0.1f}, {beta, 0}})), "the moment bias");
    const ViewRay six = sheets({-0.8f, -0.5f, -0.2f, 0.1f, 0.4f, 0.7f});
    EXPECT_EQ(of(six, "trig3-32", values_with({{theta, 3.1f}, {beta, 0}, {renormalize, 0}})),
              "the wrapping zone");
    EXPECT_EQ(of(two, "power8-16", values_with({{alpha, 1e-6f}, {beta, 0}})), "16-bit drift of the moments");
    EXPECT_EQ(of(two, "unsorted"), "the order of submission") << "front first, so that the last lies on top";
    EXPECT_EQ(of(five, "wboit"), "the method's own approximation");
    EXPECT_EQ(of(two, "mlab", values_with({{layer_bits, 1}})), "rounding to few bits");
    ViewRay mixed = two;
    mixed.shares = {{0.5f, two.fragments}, {0.5f, sheets({-0.9f, -0.7f}, 0.9f).fragments}};
    EXPECT_EQ(of(mixed, "mt", values_with({{resolution, 1}})), "the low resolution of the moments");
}

TEST(VerdictTest, SaysWhenThereIsNothingToSay) {
    const auto sentence = [](const ViewRay& ray, const char* technique) {
        return pixel_verdict(ray, require_technique(technique), {}, BEHIND).sentence;
    };
    EXPECT_NE(sentence(sheets({0.1f}), "wboit").find("Right to"), std::string::npos);
    EXPECT_NE(sentence({}, "wboit").find("Nothing transparent"), std::string::npos);
    EXPECT_NE(sentence(sheets({0.1f}), "sorted").find("is the truth"), std::string::npos);
    ViewRay many;
    for (int i = 0; i < 1001; ++i) many.fragments.push_back(plain_fragment(0, 0.01f, 0));
    EXPECT_NE(sentence(many, "power4-32").find("1000"), std::string::npos);
}

}  // namespace
}  // namespace momentscope::test
