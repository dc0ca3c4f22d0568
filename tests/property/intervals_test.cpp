// intervals_test.cpp -- the bounds of each fragment and the T between them (docs/less_error.md): against the
// truth, against exact arithmetic on the same stored floats, against the sharp bounds of exact moments, and
// in the corners where the right value is known.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "core/inspect/exact.inl"
#include "core/inspect/fragment_estimates.hpp"
#include "core/inspect/pixel_color.hpp"
#include "core/inspect/sharp_bounds.hpp"
#include "core/ray/random_ray.hpp"
#include "core/support/parallel_for.hpp"
#include "core/techniques/configuration.hpp"
#include "tests/effort.hpp"
#include "tests/property/moment_rows.hpp"

namespace momentscope::test {
namespace {

double own_absorbance(const Fragment& fragment) {
    return static_cast<double>(fragment_absorbance(fragment.opacity));
}

std::vector<const Technique*> interval_techniques() {
    std::vector<const Technique*> rows = moment_based_techniques();
    std::erase_if(rows, [](const Technique* row) { return !row->moments().estimation.has_value(); });
    return rows;
}

// Scattered fragments, clusters with gaps of 1e-4 to 1e-1, narrow rays, ties, and fragments at both ends of
// the depth range.
ViewRay any_ray(RandomNumbers& random) {
    const int kind = random.whole(0, 4);
    const int count = random.whole(1, kind == 4 ? 4 : 30);
    const float gap = std::pow(10.0f, random.uniform(-4, -1));
    const float width = std::pow(10.0f, random.uniform(-3, 0));
    const float centre = random.uniform(-0.9f, 0.9f), tie = random.uniform(-1, 1);
    const std::array<float, 3> clusters = {random.uniform(-1, 1), random.uniform(-1, 1),
                                           random.uniform(-1, 1)};
    ViewRay ray;
    for (int i = 0; i < count; ++i) {
        float depth = random.uniform(-1, 1);
        if (kind == 1)
            depth = clusters[static_cast<std::size_t>(random.whole(0, 2))] +
                    gap * static_cast<float>(random.whole(0, 5));
        if (kind == 2) depth = centre + width * depth;
        if (kind == 3 && random.whole(0, 3) == 0) depth = tie;
        if (random.whole(0, 9) == 0) depth = random.whole(0, 1) == 0 ? -1.0f : 1.0f;
        const float opacity = 0.005f + 0.98f * std::pow(random.uniform(0, 1), random.uniform(1, 3));
        ray.fragments.push_back(
            plain_fragment(std::clamp(depth, -1.0f, 1.0f), opacity, static_cast<std::size_t>(i)));
    }
    return ray;
}

struct Count {
    long queries = 0, outside = 0, exactly_outside = 0, not_finite = 0;
};

// The share of the fragments whose true absorbance lies outside of the bounds by more than 1e-4 b0. Of
// several fragments at one depth, each may be in front.
Count count_outside(const Technique& technique, int rays, std::uint32_t seed) {
    const ResolvedParameters parameters = resolve({}, technique);
    RandomNumbers random(seed);
    Count count;
    for (int i = 0; i < rays; ++i) {
        const ViewRay ray = any_ray(random);
        const auto estimates = fragment_estimates(ray, technique, parameters);
        const auto of_stored =
            exact_function_of_stored(sum_moments(ray, technique, parameters), technique, parameters);
        const auto exact = exact_estimates(of_stored, ray, parameters);
        const std::vector<float> depths = own_depths(ray);
        const std::vector<double> truth = true_absorbance(ray, depths);
        const double tolerance = 1e-4 * total_absorbance(ray);
        for (std::size_t k = 0; k < estimates.size(); ++k) {
            double most = truth[k] - own_absorbance(ray.fragments[k]);
            for (const Fragment& other : ray.fragments)
                if (other.depth == depths[k]) most += own_absorbance(other);
            const auto outside = [&](double lower, double upper) {
                return truth[k] < lower - tolerance || most > upper + tolerance;
            };
            const FragmentEstimate& e = estimates[k];
            ++count.queries;
            count.outside += outside(static_cast<double>(e.lower), static_cast<double>(e.upper)) ? 1 : 0;
            count.exactly_outside += of_stored && outside(exact[k].lower, exact[k].upper) ? 1 : 0;
            count.not_finite += std::isfinite(e.lower + e.upper + e.transmittance + e.spread) ? 0 : 1;
        }
    }
    return count;
}

class Intervals : public ::testing::TestWithParam<const Technique*> {};

// 16-bit moments are rounded by more than this tolerance; they must only be finite.
TEST_P(Intervals, HoldTheTruth) {
    constexpr std::size_t PARTS = 2;
    std::array<Count, PARTS> parts;
    parallel_for(PARTS, [&](std::size_t i) {
        parts[i] = count_outside(*GetParam(), effort(4'000, 500'000), static_cast<std::uint32_t>(i + 1));
    });
    Count all;
    for (const Count& part : parts) {
        all.queries += part.queries;
        all.outside += part.outside;
        all.exactly_outside += part.exactly_outside;
        all.not_finite += part.not_finite;
    }
    const auto share = [&](long count) {
        return static_cast<double>(count) / static_cast<double>(all.queries);
    };
    fmt::print("{}: of {} fragments {:.2e} lie outside, {:.2e} in exact arithmetic\n", GetParam()->id,
               all.queries, share(all.outside), share(all.exactly_outside));
    EXPECT_EQ(all.not_finite, 0);
    if (GetParam()->moment_kernel().bits == 16) return;
    const int moments = GetParam()->moments().moment_count;
    EXPECT_LE(share(all.outside), moments == 4 ? 1e-4 : moments == 6 ? 1e-3 : 1e-2);
    // Two nearly coinciding nodes on either side of the query are beyond floats once in 10^5 queries.
    EXPECT_LE(share(all.outside), 1.2 * share(all.exactly_outside) + 2e-5);
}

// T of floats is that of exact arithmetic at the same bias, but for rays that floats do not determine.
TEST_P(Intervals, AreThoseOfExactArithmetic) {
    const ResolvedParameters parameters = resolve({}, *GetParam());
    RandomNumbers random(5);
    std::vector<double> errors;
    for (int i = 0; i < effort(2'000, 100'000); ++i) {
        const ViewRay ray = any_ray(random);
        const auto estimates = fragment_estimates(ray, *GetParam(), parameters);
        const auto exact = exact_estimates(exact_function(ray, *GetParam(), parameters), ray, parameters);
        for (std::size_t k = 0; k < estimates.size(); ++k)
            errors.push_back(
                std::abs(static_cast<double>(estimates[k].transmittance) - exact[k].transmittance));
    }
    std::ranges::sort(errors);
    const double median = errors[errors.size() / 2], high = errors[errors.size() * 99 / 100];
    fmt::print("{}: error of T {:.1e} (median), {:.1e} (99 %), {:.1e} (worst)\n", GetParam()->id, median,
               high, errors.back());
    const bool floats = GetParam()->moment_kernel().bits == 32;
    EXPECT_LE(median, floats ? 1e-5 : 2e-2);
    EXPECT_LE(high, floats ? 0.03 : 0.5) << "16 bits round moments by 1e-5 b0";
}

INSTANTIATE_TEST_SUITE_P(Techniques, Intervals, ::testing::ValuesIn(interval_techniques()),
                         [](const auto& one) { return test_name(*one.param); });

// The ray in its own interval, as the pixel stores it.
ViewRay in_own_interval(const ViewRay& ray) {
    const auto masses = any_precision::exact_masses<Real>(ray);
    const auto steps = any_precision::steps_of_masses<Real>(masses);
    ViewRay mapped = ray;
    for (Fragment& fragment : mapped.fragments)
        fragment.depth =
            static_cast<float>(any_precision::in_interval<Real>(static_cast<Real>(fragment.depth), steps));
    return mapped;
}

// sharp_bounds computes them by another method, and linear programs check it (sharp_bounds_test.cpp). The
// moments are exact and without bias. The mapped depths are rounded to floats, which moves bounds where they
// are steep.
TEST(SharpIntervals, AreTheSharpBoundsOfExactMoments) {
    RandomNumbers random(8);
    long compared = 0;
    double worst = 0;
    for (const char* id : {"sharp4", "sharp6", "sharp8"}) {
        const Technique& technique = require_technique(id);
        ResolvedParameters parameters = resolve({}, technique);
        parameters.alpha = 0;
        for (int i = 0; i < effort(300, 10'000); ++i) {
            ViewRay ray = random_ray(random, 5 + i % 8);
            const auto exact = exact_function(ray, technique, parameters);
            if (!exact) continue;
            const ViewRay mapped = in_own_interval(ray);
            const float at = random.uniform(-0.99f, 0.99f);
            const auto sharp = sharp_bounds(mapped, technique, parameters, std::span(&at, 1));
            ASSERT_TRUE(sharp);
            const auto steps = any_precision::steps_of_masses<Real>(any_precision::exact_masses<Real>(ray));
            const Real width = steps.near + steps.far - any_precision::END_STEPS;
            const Real scene_depth =
                (static_cast<Real>(at + 1) * width / 2 - steps.near) * 2 / any_precision::END_STEPS + 1;
            const ExactFraction fraction = (*exact)(scene_depth);
            const double total = total_absorbance(ray);
            const double lower = static_cast<double>(fraction.in_front) * total;
            const double upper = static_cast<double>(fraction.with(1)) * total;
            worst = std::max({worst, std::abs(lower - static_cast<double>(sharp->lower[0])) / total,
                              std::abs(upper - static_cast<double>(sharp->upper[0])) / total});
            ++compared;
        }
    }
    fmt::print("{} rays, greatest difference {:.1e} b0\n", compared, worst);
    EXPECT_GT(compared, 500);
    EXPECT_LT(worst, 1e-4);
}

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
