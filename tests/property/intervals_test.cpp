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
#include "core/inspect/exact_estimates.hpp"
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

// The share of the fragments whose true absorbance lies outside of the bounds by more than 1e-4 b0. Any of
// several fragments at one depth may be in front.
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

// T and its spread are those of exact arithmetic at the same bias, but for rays that the stored moments do
// not determine.
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
                std::max(std::abs(static_cast<double>(estimates[k].transmittance) - exact[k].transmittance),
                         std::abs(static_cast<double>(estimates[k].spread) - exact[k].spread)));
    }
    std::ranges::sort(errors);
    const double median = errors[errors.size() / 2], high = errors[errors.size() * 99 / 100];
    fmt::print("{}: error of T or its spread {:.1e} (median), {:.1e} (99 %), {:.1e} (worst)\n",
               GetParam()->id, median, high, errors.back());
    const bool floats = GetParam()->moment_kernel().bits == 32;
    EXPECT_LE(median, floats ? 2e-7 : 5e-5) << "16 bits round a moment by 8e-6 b0";
    EXPECT_LE(high, floats ? 5e-3 : 0.06);
}

INSTANTIATE_TEST_SUITE_P(Techniques, Intervals, ::testing::ValuesIn(interval_techniques()),
                         [](const auto& one) { return test_name(*one.param); });

// sharp_bounds computes them by another method, and linear programs check it (sharp_bounds_test.cpp). The
// moments are exact and without bias. Each ray has fragments at both ends of the depth range, so its own
// interval is this range, and no mapped depth is rounded.
TEST(SharpIntervals, AreTheSharpBoundsOfExactMoments) {
    RandomNumbers random(8);
    long compared = 0, with_ends = 0;
    double worst = 0;
    for (const char* id : {"sharp4", "sharp6", "sharp8"}) {
        const Technique& technique = require_technique(id);
        ResolvedParameters parameters = resolve({}, technique);
        parameters.alpha = 0;
        ResolvedParameters of_line = parameters;
        of_line.estimation.interval = MomentInterval::scene;
        for (int i = 0; i < effort(300, 10'000); ++i) {
            ViewRay ray = random_ray(random, 5 + i % 8);
            ray.fragments[0].depth = -1;
            ray.fragments[1].depth = 1;
            const auto exact = exact_function(ray, technique, parameters);
            const auto line = exact_function(ray, technique, of_line);
            if (!exact || !line) continue;
            const float at = random.uniform(-0.99f, 0.99f);
            const auto sharp = sharp_bounds(ray, technique, parameters, std::span(&at, 1));
            ASSERT_TRUE(sharp);
            const ExactFraction fraction = (*exact)(at);
            with_ends += fraction.query_weight < Real(0.999) * (*line)(at).query_weight ? 1 : 0;
            const double total = total_absorbance(ray);
            const double lower = static_cast<double>(fraction.in_front) * total;
            const double upper = static_cast<double>(fraction.with(1)) * total;
            worst = std::max({worst, std::abs(lower - static_cast<double>(sharp->lower[0])) / total,
                              std::abs(upper - static_cast<double>(sharp->upper[0])) / total});
            ++compared;
        }
    }
    fmt::print("{} rays, {} of them narrower than on the whole line, greatest difference {:.1e} b0\n",
               compared, with_ends, worst);
    EXPECT_GT(compared, 500);
    EXPECT_GT(with_ends, compared / 5);
    EXPECT_LT(worst, 2e-6) << "the bounds are floats";
}

}  // namespace
}  // namespace momentscope::test
