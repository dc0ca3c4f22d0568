// textbook_test.cpp -- Algorithms 1 and 2 as published: correct where they can be, and failing if the bias is
// too small.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/techniques/moment_kernel.hpp"
#include "tests/property/moment_rows.hpp"
#include "tests/property/random_rays.hpp"

namespace momentscope::test {
namespace {

class Textbook : public testing::TestWithParam<const Technique*> {
protected:
    struct Outcome {
        std::vector<double> errors;  // errors of T for results in [0, 1]
        long failures = 0;           // not finite, or outside [0, 1] by more than rounding
        long queries = 0;
    };

    static Outcome measure(float alpha, int rays, int least_fragments, int most_fragments) {
        const Technique& technique = *GetParam();
        ParameterValues values;
        values.set(Solver::textbook);
        values.set(ParameterId::alpha, alpha);
        const ResolvedParameters parameters = resolve(values, technique);
        std::mt19937 random(11);
        Outcome outcome;
        for (int i = 0; i < rays; ++i) {
            ViewRay ray;
            do ray = random_ray(random, most_fragments);
            while (ray.fragments.size() < static_cast<std::size_t>(least_fragments));
            const MomentVector stored = sum_moments(ray, technique, parameters);
            const auto exact = exact_function(ray, technique, parameters);
            if (!exact) continue;
            const double b0 = total_absorbance(ray);
            for (const float depth : own_depths(ray)) {
                const float fraction =
                    technique.moment_kernel().fraction(stored, settings_of(parameters), depth);
                ++outcome.queries;
                if (!(fraction > -1e-3f && fraction < 1.001f)) {
                    ++outcome.failures;
                    continue;
                }
                const ExactFraction truth = (*exact)(static_cast<Real>(depth));
                const double expected = static_cast<double>(
                    truth.in_front + static_cast<Real>(parameters.beta) * truth.query_weight);
                outcome.errors.push_back(
                    std::abs(std::exp(-b0 * static_cast<double>(fraction)) - std::exp(-b0 * expected)));
            }
        }
        std::ranges::sort(outcome.errors);
        return outcome;
    }
};

// With a bias of a hundred thousand ulps the matrix is far from singular, so a correct implementation of the
// algorithms gives the exact result except for rounding.
TEST_P(Textbook, IsRightWhereTheMatrixIsRegular) {
    const Outcome outcome = measure(0.02f, 5000, 1, 10);
    const double median = outcome.errors[outcome.errors.size() / 2];
    const double percentile_99 = outcome.errors[outcome.errors.size() * 99 / 100];
    fmt::print("{}: {} failures of {}, median {:.1e}, 99 % {:.1e}\n", GetParam()->id, outcome.failures,
               outcome.queries, median, percentile_99);
    EXPECT_EQ(outcome.failures, 0);
    // A few ulps, magnified by a matrix with a smallest pivot of about the size of the bias; 16-bit moments
    // are off by 1e-5.
    const bool floats = GetParam()->moment_kernel().bits == 32;
    EXPECT_LT(median, floats ? 2e-7 : 2e-5);
    EXPECT_LT(percentile_99, floats ? 1e-5 : 1e-3);
}

// Without bias two surfaces make the matrix singular, and the published solver divides by a rounding error.
// Only for floats, because rounding to 16 bits already keeps matrices from being singular.
class TextbookInFloats : public Textbook {};

TEST_P(TextbookInFloats, BreaksWithoutBias) {
    const Technique& technique = *GetParam();
    ParameterValues values;
    values.set(Solver::textbook);
    values.set(ParameterId::alpha, 0.0f);
    const ResolvedParameters parameters = resolve(values, technique);
    std::mt19937 random(12);
    long failures = 0;
    constexpr int SINGULAR_RAYS = 2000;
    for (int i = 0; i < SINGULAR_RAYS; ++i) {
        const ViewRay ray = random_ray(random, 2);
        const MomentVector stored = sum_moments(ray, technique, parameters);
        const float fraction =
            technique.moment_kernel().fraction(stored, settings_of(parameters), ray.fragments.front().depth);
        failures += fraction > -1e-3f && fraction < 1.001f ? 0 : 1;
    }
    fmt::print("{}: {} of {} rays of one or two fragments fail without bias\n", technique.id, failures,
               SINGULAR_RAYS);
    EXPECT_GT(failures, SINGULAR_RAYS / 50);
}

INSTANTIATE_TEST_SUITE_P(Techniques, Textbook,
                         testing::ValuesIn(moment_techniques_where([](const Technique& row) {
                             return row.moment_kernel().has_textbook;
                         })),
                         [](const auto& row) { return test_name(*row.param); });
INSTANTIATE_TEST_SUITE_P(Techniques, TextbookInFloats,
                         testing::ValuesIn(moment_techniques_where([](const Technique& row) {
                             return row.moment_kernel().has_textbook && row.moment_kernel().bits == 32;
                         })),
                         [](const auto& row) { return test_name(*row.param); });

}  // namespace
}  // namespace momentscope::test
