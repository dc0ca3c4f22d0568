// ends_test.cpp -- surfaces at the ends of the depth range and within 1e-6 of them, where the wrapping zone
// begins and ends.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/stress/judge.hpp"
#include "core/techniques/moment_kernel.hpp"
#include "tests/effort.hpp"
#include "tests/property/moment_rows.hpp"
#include "tests/property/random_rays.hpp"

namespace momentscope::test {
namespace {

// Without a zone depths -1 and 1 are one point, and no solver can tell on which side of it a surface is.
constexpr float THETAS[] = {0.1f, std::numbers::pi_v<float> / 10, 1.0f};

class EndsOfTheDepthRange : public testing::TestWithParam<const Technique*> {
protected:
    // A surface at an end or within 1e-6 of one; every third time a second one anywhere.
    ViewRay ray_at_an_end(int i) {
        std::uniform_real_distribution<float> unit(0.0f, 1.0f), opacity(0.05f, 0.95f);
        const float end = i % 2 == 0 ? -1.0f : 1.0f;
        ViewRay ray;
        const auto add = [&](float depth) {
            ray.fragments.push_back({.depth = depth, .view_depth = depth, .opacity = opacity(random_)});
        };
        add(i % 6 < 2 ? end : end - std::copysign(1e-6f * unit(random_), end));
        if (i % 3 == 0) add(2 * unit(random_) - 1);
        return ray;
    }

    /// How many queries fail as stress counts it, at own depths, at the ends and at random depths.
    long failures(const ViewRay& ray, const ParameterValues& values, long& queries) {
        const Technique& technique = *GetParam();
        const ResolvedParameters parameters = resolve(values, technique);
        const MomentVector stored = sum_moments(ray, technique, parameters);
        std::uniform_real_distribution<float> anywhere(-1.0f, 1.0f);
        std::vector<float> depths = own_depths(ray);
        depths.insert(depths.end(), {-1.0f, 1.0f, anywhere(random_), anywhere(random_)});
        const auto exact = exact_function(ray, technique, parameters);
        const std::vector<double> exactly = exact_absorbance(exact, ray, parameters.beta, depths);
        long failed = 0;
        for (std::size_t k = 0; k < depths.size(); ++k) {
            const float fraction = technique.kernel->fraction(stored, settings_of(parameters), depths[k]);
            const double t = transmittance_of_fraction(fraction, stored.b0);
            const bool fine = judge(fraction, t, std::exp(-exactly[k])) == Outcome::fine;
            if (!fine && failed == 0 && printed_++ < 3)
                fmt::print("{} theta {}: depth {:.9g} of fragments at {:.9g}: T {:.4f}, exactly {:.4f}\n",
                           technique.id, parameters.theta, depths[k], ray.fragments.front().depth, t,
                           std::exp(-exactly[k]));
            failed += fine ? 0 : 1;
            ++queries;
        }
        return failed;
    }

    std::mt19937 random_{17};
    int printed_ = 0;
};

TEST_P(EndsOfTheDepthRange, HoldNoSurprise) {
    for (const float theta : THETAS) {
        if (!GetParam()->uses(ParameterId::theta) && theta != THETAS[0]) break;
        ParameterValues values;
        values.set(ParameterId::theta, theta);
        long queries = 0, failed = 0;
        printed_ = 0;
        for (int i = effort(2'000, 100'000); i > 0; --i)
            failed += failures(ray_at_an_end(i), values, queries);
        fmt::print("{} theta {}: {} of {} queries fail\n", GetParam()->id, theta, failed, queries);
        // Before the seam was closed 50 to 70 queries failed. What is left are float moments of a
        // surface and a query that are a zone of .1 apart, off by .023 at most.
        if (GetParam()->kernel->bits == 32) {
            EXPECT_LE(failed, queries / 5000) << "theta " << theta;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Techniques, EndsOfTheDepthRange, testing::ValuesIn(moment_based_techniques()),
                         [](const auto& row) { return test_name(*row.param); });

}  // namespace
}  // namespace momentscope::test
