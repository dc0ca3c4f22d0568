// robustness_test.cpp -- for all fragments, results are finite numbers within their range.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/effort.hpp"
#include "tests/property/moment_rows.hpp"
#include "tests/property/random_rays.hpp"

namespace momentscope::test {
namespace {

class Robustness : public testing::TestWithParam<const Technique*> {
protected:
    // Checks unclamped fractions and weights at one depth, and counts floors and clamps.
    void check(const MomentVector& moments, const ReconstructionSettings& settings, float depth) {
        const ReconstructionSteps steps = GetParam()->moment_kernel().steps(moments, settings, depth);
        const float beta0 = steps.in_front;
        const float beta1 = steps.in_front + steps.query_weight;
        const bool fine = beta0 >= -1e-4f && beta1 <= 1 + 1e-4f && beta1 >= beta0 && steps.absorbance >= 0 &&
                          steps.absorbance <= moments.b0;  // false for NaN
        failures_ += fine ? 0 : 1;
        clamped_ += beta1 > 1 ? 1 : 0;
        floored_ += steps.floored_pivots;
        ++queries_;
        if (!fine && failures_ <= 3)
            ADD_FAILURE() << fmt::format("{}: depth {} b0 {} beta0 {} beta1 {}", GetParam()->id, depth,
                                         moments.b0, beta0, beta1);
    }
    void check_ray(const ViewRay& ray, const std::vector<float>& depths, const ParameterValues& values) {
        const ResolvedParameters p = resolve(values, *GetParam());
        const MomentVector moments = sum_moments(ray, *GetParam(), p);
        for (const float depth : depths) check(moments, settings_of(p), depth);
    }
    void report(const char* what) const {
        fmt::print("{} {}: {} queries, {} failures, {} sums above 1 clamped, {} pivots floored\n",
                   GetParam()->id, what, queries_, failures_, clamped_, floored_);
        EXPECT_EQ(failures_, 0);
    }

    long queries_ = 0, failures_ = 0, clamped_ = 0, floored_ = 0;
};

TEST_P(Robustness, RandomRaysAtOwnAndRandomDepths) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> depth(-1.0f, 1.0f);
    for (int i = effort(100'000, 1'000'000); i > 0; --i) {
        const ViewRay ray = random_ray(random);
        std::vector<float> depths = own_depths(ray);
        for (int k = 0; k < 3; ++k) depths.push_back(depth(random));
        check_ray(ray, depths, {});
    }
    report("random rays");
}

TEST_P(Robustness, RandomRaysWithTheRobustBias) {
    ParameterValues values;
    values.set(BiasPreset::robust);
    std::mt19937 random(4);
    for (int i = effort(100'000, 1'000'000); i > 0; --i) {
        const ViewRay ray = random_ray(random);
        check_ray(ray, own_depths(ray), values);
    }
    report("random rays, robust bias");
}

TEST_P(Robustness, SingleFragmentsEverywhere) {
    const int last = effort(20'000, 200'000);
    for (int i = 0; i <= last; ++i) {
        ViewRay ray;
        const float depth = 2 * static_cast<float>(i) / static_cast<float>(last) - 1.0f;
        ray.fragments.push_back({.depth = depth, .view_depth = depth, .opacity = 0.5f});
        check_ray(ray, {depth, -1.0f, 1.0f, std::nextafter(depth, -1.0f), std::nextafter(depth, 1.0f)}, {});
    }
    report("single fragments");
}

TEST_P(Robustness, TiesEndsAndExtremeOpacities) {
    std::mt19937 random(2);
    const std::vector<float> depths = {-1.0f, -0.999999f, -1e-30f,   0.0f, 1e-7f,
                                       0.5f,  0.5000001f, 0.999999f, 1.0f};
    const std::vector<float> opacities = {0.0f, 1e-38f,  1e-20f,   1e-7f, 1.0f / 255,
                                          0.5f, 0.9999f, 0.99999f, 1.0f};
    const auto pick = [&](const std::vector<float>& from) {
        return from[std::uniform_int_distribution<std::size_t>(0, from.size() - 1)(random)];
    };
    for (int i = effort(50'000, 200'000); i > 0; --i) {
        ViewRay ray;
        for (int n = 1 + i % 6; n > 0; --n) {
            const float depth = pick(depths);
            ray.fragments.push_back({.depth = depth, .view_depth = depth, .opacity = pick(opacities)});
        }
        check_ray(ray, depths, {});
    }
    report("ties, ends and extreme opacities");
}

TEST_P(Robustness, AnyParameters) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    for (int i = effort(30'000, 100'000); i > 0; --i) {
        ParameterValues values;
        for (const ParameterId id : {ParameterId::beta, ParameterId::theta, ParameterId::alpha}) {
            const Parameter& row = parameter(id);
            const int choice = i % 4;  // including the ends of the range: no bias, no wrapping zone
            const float share = choice == 0 ? 0.0f : choice == 1 ? 1.0f : unit(random);
            values.set(
                id, std::clamp(row.minimum + share * (row.maximum - row.minimum), row.minimum, row.maximum));
        }
        const ViewRay ray = random_ray(random);
        std::vector<float> depths = own_depths(ray);
        depths.insert(depths.end(), {-1.0f, 1.0f, unit(random)});
        check_ray(ray, depths, values);
    }
    report("any parameters");
}

TEST_P(Robustness, NothingThereAbsorbsNothing) {
    const Curve curve = sample_curve({}, *GetParam(), {}, even_depths(16));
    for (const float absorbance : curve.beta1) EXPECT_EQ(absorbance, 0.0f);
}

INSTANTIATE_TEST_SUITE_P(Techniques, Robustness, testing::ValuesIn(kernel_techniques()),
                         [](const auto& row) { return test_name(*row.param); });

}  // namespace
}  // namespace momentscope::test
