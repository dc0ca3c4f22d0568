// stress_test.cpp -- stress finds exactly the known failures; tune finds the values that the papers found by
// hand.
#include "core/stress/stress.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "core/inspect/fragment_estimates.hpp"
#include "core/inspect/step_texts.hpp"
#include "core/ray/ray_json.hpp"
#include "core/report/stress_report.hpp"
#include "core/stress/tune.hpp"
#include "core/support/error.hpp"
#include "core/techniques/moment_kernel.hpp"
#include "tests/property/moment_rows.hpp"
#include "tests/property/random_rays.hpp"

namespace momentscope::test {
namespace {

const auto NO_REPORT = [](std::size_t, std::size_t) {};

StressOptions options_of(std::vector<const char*> techniques, std::vector<const char*> conditions,
                         int rays = 200) {
    StressOptions options;
    for (const char* id : techniques) options.techniques.push_back(&require_technique(id));
    for (const char* id : conditions) options.conditions.push_back(&require_condition(id));
    options.rays = rays;
    return options;
}

TEST(Stress, ConditionsAreWhatTheirNamesSay) {
    std::set<std::string> ids;
    for (const Condition& condition : conditions()) {
        EXPECT_TRUE(ids.insert(condition.id).second) << condition.id;
        EXPECT_EQ(condition.help.back(), '.') << condition.id;
        RandomNumbers random(3);
        const StressCase tried = condition.make(random, require_technique("power8-32"), {});
        EXPECT_FALSE(tried.ray.fragments.empty()) << condition.id;
        for (const Fragment& fragment : tried.ray.fragments) {
            EXPECT_TRUE(fragment.depth >= -1 && fragment.depth <= 1) << condition.id;
            EXPECT_TRUE(fragment.opacity > 0 && fragment.opacity < 1) << condition.id;
        }
    }
    const auto ray_of = [](const char* id, const char* technique) {
        RandomNumbers random(1);
        return require_condition(id).make(random, require_technique(technique), {}).ray;
    };
    EXPECT_EQ(ray_of("nodes", "power8-32").fragments.size(), 4u);
    EXPECT_EQ(ray_of("nodes+1", "trig3-32").fragments.size(), 4u);
    EXPECT_EQ(ray_of("overdraw-1000", "power4-32").fragments.size(), 1000u);
    const ViewRay pair = ray_of("gap-1e-3", "power4-32");
    EXPECT_NEAR(pair.fragments[1].depth - pair.fragments[0].depth, 1e-3f, 1e-6f);
}

TEST(Stress, IsTheSameWhateverTheThreadsDo) {
    const StressOptions options = options_of({"power4-16", "trig3-32"}, {"two", "alpha-0", "ties"}, 50);
    const auto first = run_stress(options, {}, NO_REPORT);
    const auto second = run_stress(options, {}, NO_REPORT);
    EXPECT_EQ(stress_to_csv(first), stress_to_csv(second));
    StressOptions other = options;
    other.seed = 2;
    EXPECT_NE(stress_to_csv(first), stress_to_csv(run_stress(other, {}, NO_REPORT)));
}

TEST(Stress, SeesTheTextbookBreakWithoutBiasAndTheRobustSolverHold) {
    StressOptions options = options_of({"power4-32", "power6-32", "power8-32"}, {"alpha-0"});
    options.values.set(Solver::textbook);
    for (const StressCell& cell : run_stress(options, {}, NO_REPORT)) {
        EXPECT_GT(cell.failures(), cell.queries / 200) << cell.technique->id;
        EXPECT_FALSE(cell.worst_case.ray.fragments.empty());
    }
    options.values.set(Solver::robust);
    for (const StressCell& cell : run_stress(options, {}, NO_REPORT)) {
        EXPECT_EQ(cell.not_numbers + cell.outside, 0) << cell.technique->id;
        EXPECT_LT(cell.failure_rate(), 0.03) << cell.technique->id;
    }
}

TEST(Stress, KnowsWhatItMeasures) {
    // 10,000 fragments in half floats: each one adds less than half a step of b0, so the sum stops growing.
    const auto cells =
        run_stress(options_of({"power4-16", "power4-32"}, {"overdraw-10000"}, 100), {}, NO_REPORT);
    EXPECT_GT(cells[0].failure_rate(), 0.9);
    EXPECT_EQ(cells[1].failure_rate(), 0.0);
    // The results for beta = 0 and 1 are not bounds for trigonometric moments, but they are for power
    // moments.
    const auto bounds = run_stress(options_of({"power4-32", "trig2-32"}, {"overdraw-10"}), {}, NO_REPORT);
    EXPECT_EQ(bounds[0].truth_outside, 0);
    EXPECT_GT(bounds[1].truth_outside, bounds[1].queries / 50);
    EXPECT_EQ(bounds[0].order_dependent, 0) << "sums of floats";
}

TEST(Stress, StopsWhenItIsAsked) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_TRUE(run_stress(options_of({"power4-32"}, {"two"}), stop.get_token(), NO_REPORT).empty());
}

TEST(Stress, ReportsHoldEveryCellAndItsWorstRay) {
    const StressOptions options = options_of({"power8-32", "trig4-16"}, {"alpha-0", "two"}, 50);
    const auto cells = run_stress(options, {}, NO_REPORT);
    const std::string csv = stress_to_csv(cells);
    EXPECT_EQ(std::ranges::count(csv, '\n'), 5);
    const auto open = csv.find("\"{");
    ASSERT_NE(open, std::string::npos);
    std::string quoted = csv.substr(open + 1, csv.find("}\"\n", open) - open);
    for (auto at = quoted.find("\"\""); at != std::string::npos; at = quoted.find("\"\"", at + 1))
        quoted.erase(at, 1);
    const ViewRay read = ray_from_json(quoted);
    const ViewRay& worst = cells[0].worst_case.ray;
    ASSERT_EQ(read.fragments.size(), worst.fragments.size());
    for (std::size_t i = 0; i < worst.fragments.size(); ++i) {
        EXPECT_EQ(read.fragments[i].depth, worst.fragments[i].depth) << "every digit";
        EXPECT_EQ(read.fragments[i].opacity, worst.fragments[i].opacity);
    }
    const std::string html = stress_to_html(cells, options);
    EXPECT_NE(html.find("trig4-16"), std::string::npos);
    EXPECT_EQ(html.find("src="), std::string::npos) << "self-contained";
}

TEST(Tune, FindsLessBiasWithTheRobustSolverThanWithTheTextbook) {
    const auto rays = tuning_rays(4000, 1);
    TuneOptions options;
    options.technique = &require_technique("power8-32");
    const float table1 = options.technique->moments().recommended_bias;
    const auto robust = tune(rays, options, {}, NO_REPORT);
    options.values.set(Solver::textbook);
    const auto textbook = tune(rays, options, {}, NO_REPORT);
    ASSERT_TRUE(robust && textbook);
    const float robust_alpha = *robust->values[ParameterId::alpha];
    const float textbook_alpha = *textbook->values[ParameterId::alpha];
    fmt::print("power8-32: robust {:.2g}, textbook {:.2g}, Table 1 {:.2g}\n", robust_alpha, textbook_alpha,
               table1);
    EXPECT_LE(robust_alpha, table1 / 10);
    EXPECT_GE(textbook_alpha, 4 * robust_alpha);
    EXPECT_GE(textbook_alpha, table1 / 10);
    EXPECT_GT(robust_alpha, 5e-9f) << "not at the lower end of the search";
    EXPECT_LT(robust->error, robust->error_before);
    EXPECT_TRUE(robust->safe && robust->failure_rate <= options.most_failures);
}

TEST(Tune, ErrorsAreThoseOfItsTrials) {
    // With one fragment, only beta matters: the error at its own depth is exp(-beta a) against 1.
    ViewRay ray;
    ray.fragments.push_back(plain_fragment(0.3f, 0.5f, 0));
    TuneOptions options;
    options.technique = &require_technique("power4-32");
    const auto result = tune({ray}, options, {}, NO_REPORT);
    ASSERT_TRUE(result);
    EXPECT_EQ(*result->values[ParameterId::beta], 0.0f);
    for (const Trial& trial : result->trials)
        if (trial.parameter == ParameterId::beta) {
            EXPECT_NEAR(trial.error, 1 - std::exp(-std::log(2.0) * static_cast<double>(trial.value)), 1e-3);
        }
}

TEST(Tune, TheLeastSafeBiasHasOnlySafeOnesAboveIt) {
    TuneResult result;
    for (const auto& [value, rate] :
         {std::pair(1e-6f, 0.0), std::pair(1e-5f, 0.2), std::pair(1e-4f, 0.001), std::pair(1e-3f, 0.0)})
        result.trials.push_back({ParameterId::alpha, value, 0, rate});
    EXPECT_EQ(least_safe_bias(result, 1e-3), 1e-4f) << "1e-6 was luck";
    EXPECT_EQ(least_safe_bias(result, 1e-4), 1e-3f);
    result.trials.back().failure_rate = 1;
    EXPECT_EQ(least_safe_bias(result, 1e-3), std::nullopt);
}

TEST(Tune, SaysWhatItCannotDo) {
    TuneOptions options;
    options.technique = &require_technique("sorted");
    EXPECT_THROW(tune(tuning_rays(2, 1), options, {}, NO_REPORT), Error);
    options.technique = &require_technique("power4-32");
    EXPECT_THROW(tune({ViewRay()}, options, {}, NO_REPORT), Error);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(tune(tuning_rays(2, 1), options, stop.get_token(), NO_REPORT));
}

// The preset `robust` must have at most 0.65 times the error of Table 1, for eight power moments, beta = 0,
// and 2 to 5 fragments.
TEST(RobustBias, OfEightPowerMomentsIsSharperThanTableOne) {
    const auto rays = tuning_rays(20'000, 3);
    const Technique& technique = require_technique("power8-32");
    const auto rms = [&](float alpha) {
        ParameterValues values;
        values.set(ParameterId::alpha, alpha);
        values.set(ParameterId::beta, 0.0f);
        double squares = 0;
        long count = 0;
        for (const ViewRay& ray : rays) {
            const std::vector<float> depths = own_depths(ray);
            const Curve curve = sample_curve(ray, technique, values, depths);
            for (std::size_t i = 0; i < depths.size(); ++i) {
                const double error =
                    std::exp(-static_cast<double>(curve.reconstructed[i])) - std::exp(-curve.truth[i]);
                squares += error * error;
                ++count;
            }
        }
        return std::sqrt(squares / static_cast<double>(count));
    };
    const double ratio = rms(technique.moments().robust_bias) / rms(technique.moments().recommended_bias);
    fmt::print("power8-32, robust to Table 1: {:.3f}\n", ratio);
    EXPECT_LE(ratio, 0.65);
}

class StepsTest : public testing::TestWithParam<const Technique*> {};

TEST_P(StepsTest, EndInWhatTheSecondPassTakes) {
    std::mt19937 random(9);
    for (int i = 0; i < 100; ++i) {
        const ViewRay ray = random_ray(random);
        const std::vector<float> depths = own_depths(ray);
        const Curve curve = sample_curve(ray, *GetParam(), {}, depths);
        for (std::size_t k = 0; k < depths.size(); ++k) {
            const Steps steps = reconstruction_steps(curve, depths[k]);
            EXPECT_EQ(steps.absorbance, curve.reconstructed[k]) << "bit for bit";
            float sum = steps.query_weight;
            for (const StepNode& node : steps.nodes) sum += node.weight;
            EXPECT_NEAR(sum, 1, 1e-5f);
            EXPECT_EQ(step_texts(steps).size(), 8u);
            EXPECT_NEAR(steps.pivots[0], 1, 1e-6f) << "E[1]";
            EXPECT_EQ(steps.after.order, steps.nodes.size() + 1);
        }
    }
}

TEST_P(StepsTest, OfMomentsWithMuchBiasShowARegularMatrix) {
    ViewRay ray;
    ray.fragments.push_back(plain_fragment(0.2f, 0.5f, 0));
    ParameterValues values;
    values.set(ParameterId::alpha, 0.05f);
    const float at[] = {0.2f};
    const Steps steps = reconstruction_steps(sample_curve(ray, *GetParam(), values, at), 0.2f);
    EXPECT_LT(std::abs(steps.before.smallest_eigenvalue), 1e-3)
        << "one fragment: rank 1 but for 16-bit rounding";
    EXPECT_GT(steps.after.smallest_eigenvalue, 1e-6);
    EXPECT_GT(steps.after.smallest_eigenvalue, steps.before.smallest_eigenvalue);
}

class FragmentSteps : public testing::TestWithParam<const Technique*> {};

// What the second pass computes for a fragment, which its own absorbance and the ends of its ray bound.
TEST_P(FragmentSteps, EndInTheEstimateOfTheFragment) {
    std::mt19937 random(10);
    for (int i = 0; i < 50; ++i) {
        const ViewRay ray = random_ray(random);
        const std::vector<float> depths = own_depths(ray);
        const float nearest = *std::ranges::min_element(depths);
        const Curve curve = sample_curve(ray, *GetParam(), {}, depths);
        const auto estimates = fragment_estimates(ray, *GetParam(), curve.parameters);
        for (const float depth : depths) {
            const Fragment* fragment = fragment_at(ray, depth);
            ASSERT_NE(fragment, nullptr);
            const FragmentEstimate& expected =
                estimates[static_cast<std::size_t>(fragment - ray.fragments.data())];
            const Steps steps = reconstruction_steps(curve, depth, fragment);
            EXPECT_EQ(steps.transmittance, expected.transmittance) << "bit for bit";
            EXPECT_EQ(steps.own, fragment_absorbance(fragment->opacity));
            const bool near = steps.end == RayEnd::near || steps.end == RayEnd::both;
            EXPECT_EQ(near, depth - nearest < 1e-6f) << "steps of ends are 3e-5, and depths far apart";
            const bool none_in_front = near && curve.parameters.in_own_interval();
            EXPECT_TRUE(!none_in_front || steps.lower == 0);
            EXPECT_EQ(step_texts(steps).back().numbers.find("nan"), std::string::npos);
        }
    }
    EXPECT_EQ(fragment_at({}, 0.5f), nullptr);
}

INSTANTIATE_TEST_SUITE_P(Techniques, FragmentSteps, testing::ValuesIn(interval_techniques()),
                         [](const auto& row) { return test_name(*row.param); });

INSTANTIATE_TEST_SUITE_P(Techniques, StepsTest, testing::ValuesIn(kernel_techniques()),
                         [](const auto& row) { return test_name(*row.param); });

}  // namespace
}  // namespace momentscope::test
