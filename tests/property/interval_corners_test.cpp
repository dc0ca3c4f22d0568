// interval_corners_test.cpp -- estimates where the right value is known: nothing, one fragment, ties, ends,
// opaque fragments, much bias; and the renormalisation of what is uncertain.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/inspect/fragment_estimates.hpp"
#include "core/inspect/pixel_color.hpp"
#include "core/ray/random_ray.hpp"
#include "core/techniques/configuration.hpp"
#include "tests/property/moment_rows.hpp"

namespace momentscope::test {
namespace {

// Every technique of this kind, and the parameters on a published one of each basis.
std::vector<Configuration> configurations() {
    std::vector<Configuration> all;
    for (const Technique* row : interval_techniques()) all.push_back({row, {}});
    for (const char* text :
         {"trig3-32:estimate=expected,ends=known,renormalize=uncertain",
          "trig2-16:estimate=expected,ends=known", "power4-32:estimate=own-beta",
          "adaptive:estimate=expected,ends=known", "power6-32:estimate=beta,ends=known,interval=pixel",
          "trig4-32:estimate=own-beta,ends=known,interval=pixel"})
        all.push_back(parse_configuration(text));
    return all;
}

ViewRay ray_of(const std::vector<std::pair<float, float>>& depths_and_opacities) {
    ViewRay ray;
    for (const auto& [depth, opacity] : depths_and_opacities)
        ray.fragments.push_back(plain_fragment(depth, opacity, ray.fragments.size()));
    return ray;
}

class Corners : public ::testing::TestWithParam<Configuration> {
protected:
    std::vector<FragmentEstimate> of(const ViewRay& ray) const {
        const auto estimates =
            fragment_estimates(ray, *GetParam().technique, resolve(GetParam().values, *GetParam().technique));
        for (const FragmentEstimate& e : estimates) {
            EXPECT_TRUE(std::isfinite(e.lower) && std::isfinite(e.upper)) << "bounds";
            EXPECT_GE(e.lower, 0);
            EXPECT_LE(e.lower, e.upper);
            EXPECT_GE(e.transmittance, 0);
            EXPECT_LE(e.transmittance, 1);
            EXPECT_GE(e.spread, 0);
        }
        return estimates;
    }
    bool expects() const {
        return resolve(GetParam().values, *GetParam().technique).estimation.estimate == Estimate::expected;
    }
    // 16-bit moments round absorbances to halves, and the circle has a wrapping zone.
    float tolerance() const {
        if (GetParam().technique->moment_kernel().bits == 16) return 2e-2f;
        return GetParam().technique->on_circle() ? 2e-2f : 1e-3f;
    }
};

TEST_P(Corners, NothingAbsorbs) {
    for (const FragmentEstimate& e : of(ray_of({{-0.2f, 0.0f}, {0.4f, 0.0f}}))) EXPECT_EQ(e.transmittance, 1);
}

TEST_P(Corners, OneFragmentDoesNotOccludeItself) {
    const bool published = resolve(GetParam().values, *GetParam().technique).is_published();
    for (const float opacity : {0.01f, 0.5f, 1.0f}) {
        const FragmentEstimate e = of(ray_of({{0.3f, opacity}})).front();
        if (!published) {
            EXPECT_NEAR(e.transmittance, 1, tolerance());
        }
        EXPECT_NEAR(e.upper, 0, 10 * tolerance());
    }
}

TEST_P(Corners, TwoFragmentsAreDetermined) {
    const auto e = of(ray_of({{-0.4f, 0.5f}, {0.3f, 0.3f}}));
    if (!expects()) return;
    EXPECT_NEAR(e[0].transmittance, 1, tolerance());
    EXPECT_NEAR(e[1].transmittance, 0.5f, tolerance());
}

// Any order of three surfaces at one depth is possible: [0, b0 - a].
TEST_P(Corners, AllAtOneDepthMayBeInAnyOrder) {
    const auto e = of(ray_of({{0.25f, 0.5f}, {0.25f, 0.5f}, {0.25f, 0.5f}}));
    const float others = 2 * fragment_absorbance(0.5f);
    for (const FragmentEstimate& one : e) {
        EXPECT_NEAR(one.lower, 0, tolerance());
        EXPECT_NEAR(one.upper, others, 5 * tolerance());
        if (expects()) {
            EXPECT_NEAR(one.transmittance, (1 - std::exp(-others)) / others, tolerance());
        }
    }
}

TEST_P(Corners, TiesAtAnEndAreUncertain) {
    const auto e = of(ray_of({{-1, 0.5f}, {-1, 0.5f}, {1, 0.5f}}));
    const float one = fragment_absorbance(0.5f);
    EXPECT_LE(e[0].lower, tolerance());
    EXPECT_GE(e[0].upper, one - 5 * tolerance()) << "the other one may be in front";
    EXPECT_LE(e[2].upper, 2 * one + 5 * tolerance());
}

// All mass at the two ends of the interval, so the inner measure has none.
TEST_P(Corners, MassOnlyAtTheEnds) {
    const auto e = of(ray_of({{-1, 0.7f}, {1, 0.6f}}));
    if (!expects()) return;
    EXPECT_NEAR(e[0].transmittance, 1, tolerance());
    EXPECT_NEAR(e[1].transmittance, 0.3f, tolerance());
}

TEST_P(Corners, OpaqueFragments) {
    const auto e = of(ray_of({{-0.5f, 1.0f}, {0.0f, 1.0f}, {0.5f, 1.0f}}));
    if (!expects()) return;
    EXPECT_NEAR(e[0].transmittance, 1, 5 * tolerance());
    EXPECT_LE(e[2].transmittance, 1e-3f);
}

// Much bias makes the mass at the query smaller than the fragment itself; the bounds still have an order.
TEST_P(Corners, MuchBias) {
    Configuration biased = GetParam();
    biased.values.set(ParameterId::alpha, 0.1f);
    for (const FragmentEstimate& e :
         fragment_estimates(ray_of({{-0.4f, 0.9f}, {0.1f, 0.9f}, {0.6f, 0.9f}}), *biased.technique,
                            resolve(biased.values, *biased.technique))) {
        EXPECT_LE(e.lower, e.upper);
        EXPECT_TRUE(std::isfinite(e.transmittance));
    }
}

TEST_P(Corners, DepthsThatAreNoNumbers) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const FragmentEstimate& e : of(ray_of({{-0.4f, 0.5f}, {nan, 0.5f}, {0.3f, 0.3f}})))
        EXPECT_TRUE(std::isfinite(e.transmittance));
}

// A trace of smoke in front of everything moves no end. T is wrong by no more than the trace absorbs.
TEST_P(Corners, FaintFragmentsBeyondAnEnd) {
    const auto e = of(ray_of({{-0.9f, 0.003f}, {-0.1f, 0.5f}, {0.2f, 0.5f}, {0.95f, 0.003f}}));
    if (!expects()) return;
    EXPECT_NEAR(e[1].transmittance, 1, 0.0031f + tolerance());
    EXPECT_NEAR(e[2].transmittance, 0.5f, 0.0031f + tolerance());
}

INSTANTIATE_TEST_SUITE_P(Configurations, Corners, ::testing::ValuesIn(configurations()), [](const auto& one) {
    return fmt::format("{}_{}", one.index, test_name(*one.param.technique));
});

TEST(UncertainRenormalization, LeavesWhatIsCertain) {
    ResolvedParameters parameters;
    parameters.estimation.renormalization = Renormalization::uncertain;
    const glm::vec3 nothing(0);
    const float absorbance = std::log(4.0f);  // coverage 3/4
    // Without spreads it is the uniform one.
    EXPECT_NEAR(composited_color({0.2f, 0.2f, 0.2f, 0.5f}, glm::vec4(0), absorbance, parameters, nothing).r,
                0.3f, 1e-6f);
    // With spreads, only uncertain colours (here blue) grow: 1/2 + 1/4 is the coverage.
    const glm::vec3 moved =
        composited_color({0.5f, 0, 0.1f, 0.5f}, {0, 0, 0.5f, 0.5f}, absorbance, parameters, nothing);
    EXPECT_NEAR(moved.r, 0.5f, 1e-6f);
    EXPECT_NEAR(moved.b, 0.35f, 1e-6f);
    // Weights move by no more than their spread; what is still missing is scaled.
    const glm::vec3 limited =
        composited_color({0.25f, 0, 0, 0.25f}, {0, 0, 0.25f, 0.25f}, absorbance, parameters, nothing);
    EXPECT_NEAR(limited.r, 0.375f, 1e-6f);
    EXPECT_NEAR(limited.b, 0.375f, 1e-6f);
}

}  // namespace
}  // namespace momentscope::test
