// fragment_moments_test.cpp -- what fragments add to the moments: textbook formulas, and sums that are the
// moments of the ray.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/inspect/fragment_moments.hpp"
#include "core/ray/random_ray.hpp"

namespace momentscope::test {
namespace {

ViewRay some_ray() {
    RandomNumbers random(11);
    return random_ray(random, 6);
}

Curve curve_of(const ViewRay& ray, const char* technique) {
    return sample_curve(ray, require_technique(technique), {}, std::vector<float>{0});
}

// The j-th function of depth in double, j from 0; independent of shaders/shared.
double function_of(const Technique& technique, int j, double z, double theta) {
    if (technique.on_circle()) {
        const double phase = (2 * std::numbers::pi - theta) * (z + 1) / 2 * (j / 2 + 1);
        return j % 2 == 0 ? std::cos(phase) : std::sin(phase);
    }
    if (technique.is_of(BasisFamily::chebyshev)) return std::cos((j + 1) * std::acos(z));
    return std::pow(z, j + 1);
}

TEST(FragmentMoments, AreAbsorbanceTimesAFunctionOfDepth) {
    const ViewRay ray = some_ray();
    for (const char* id : {"power8-32", "trig4-32", "cheb8-32"}) {
        const Curve curve = curve_of(ray, id);
        const auto rows = fragment_moments(ray, curve);
        const auto names = moment_names(*curve.technique);
        ASSERT_EQ(rows.size(), ray.fragments.size());
        ASSERT_EQ(names.size(), 8U);
        for (std::size_t l = 0; l < rows.size(); ++l) {
            const auto z = static_cast<double>(ray.fragments[l].depth);
            const double a = -std::log1p(-static_cast<double>(ray.fragments[l].opacity));
            EXPECT_NEAR(rows[l].b0, a, 1e-5 * (1 + a)) << id;
            for (int j = 0; j < 8; ++j)
                EXPECT_NEAR(
                    rows[l].b[static_cast<std::size_t>(j)],
                    a * function_of(*curve.technique, j, z, static_cast<double>(curve.parameters.theta)),
                    2e-5 * (1 + a))  // floats, and the shaders' logarithm
                    << id << ", " << names[static_cast<std::size_t>(j)];
        }
    }
}

TEST(FragmentMoments, SumToTheMomentsOfTheRay) {
    const ViewRay ray = some_ray();
    for (const Technique* technique : moment_based_techniques()) {
        const Curve curve = curve_of(ray, technique->id);
        const MomentVector sum = ray_moments(curve);
        MomentVector added;
        for (const MomentVector& row : fragment_moments(ray, curve)) {
            added.b0 += row.b0;
            for (std::size_t j = 0; j < added.b.size(); ++j) added.b[j] += row.b[j];
        }
        // In 16 bits the sum is rounded after each fragment.
        const float tolerance = technique->moment_kernel().bits == 32 ? 1e-5f : 1e-3f;
        const std::size_t count = moment_names(*technique).size();
        for (std::size_t j = 0; j < count; ++j)
            EXPECT_NEAR(added.b[j], sum.b[j], tolerance * (1 + sum.b0)) << technique->id << ", " << j;
    }
}

TEST(FragmentMoments, AreEmptyWithoutMoments) {
    const ViewRay ray = some_ray();
    EXPECT_TRUE(fragment_moments(ray, curve_of(ray, "wboit")).empty());
}

}  // namespace
}  // namespace momentscope::test
