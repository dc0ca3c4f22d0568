// advice_test.cpp -- which row of a chart is advised for which bounds.
#include "core/chart/advice.hpp"
#include "core/report/advice_text.hpp"
#include "tests/unit/expect_error.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>

using namespace momentscope;

namespace {

ChartRow row_of(const std::string& configuration, double total, std::optional<int> bits, double error,
                double range = 0) {
    ChartNumbers numbers;
    numbers.total = {total, range};
    numbers.bits_with_factor = bits;
    numbers.rmse = error;
    numbers.delta_e = 100 * error;
    numbers.flip = 2 * error;
    return {"planes", configuration, "", numbers};
}

// Sorted from the fastest to the slowest.
const std::vector<ChartRow> ROWS = {row_of("unsorted", 1, 0, 0.2),
                                    row_of("wboit", 2, 64, 0.1),
                                    row_of("at", 4, 320, 0.02),
                                    row_of("power4-32", 6, 160, 0.04),
                                    row_of("power8-32", 10, 288, 0.005),
                                    row_of("sorted", 20, std::nullopt, 0),
                                    {"planes", "mlab", "This GL has no ordered access, so there.", {}}};

AdviceBounds error_of_at_most(double error) {
    AdviceBounds bounds;
    bounds.max_error = error;
    return bounds;
}

HeldOutErrors unknown(const std::vector<ChartRow>& rows = ROWS) {
    return HeldOutErrors(rows.size());
}

using Row = std::optional<std::size_t>;

TEST(Advice, TheFastestThatMeetsTheErrorWins) {
    const Advice advice = advise(ROWS, error_of_at_most(0.05), unknown());
    EXPECT_EQ(advice.winner, Row(2));
    EXPECT_EQ(advice.runner_up, Row(3));
    EXPECT_EQ(advice.next_better, Row(4)) << "power4-32 is slower and worse";
    EXPECT_EQ(advice.nearest, std::nullopt);
}

TEST(Advice, LimitsAreInclusive) {
    EXPECT_EQ(advise(ROWS, error_of_at_most(0.02), unknown()).winner, Row(2));
    AdviceBounds bounds = error_of_at_most(0.04);
    bounds.max_bits = 160;
    bounds.max_ms = 6.0;
    EXPECT_EQ(advise(ROWS, bounds, unknown()).winner, Row(3));
    EXPECT_EQ(advise(ROWS, bounds, unknown()).runner_up, std::nullopt);
    bounds.max_ms = 5.99;
    EXPECT_EQ(advise(ROWS, bounds, unknown()).winner, std::nullopt);
}

TEST(Advice, WhatDependsOnTheOrderIsLeftOutWhenAsked) {
    AdviceBounds bounds = error_of_at_most(0.3);
    EXPECT_EQ(advise(ROWS, bounds, unknown()).winner, Row(0));
    bounds.order_independent = true;
    const Advice advice = advise(ROWS, bounds, unknown());
    EXPECT_EQ(advice.winner, Row(1));
    EXPECT_EQ(advice.runner_up, Row(3)) << "at sorts in bounded memory";
    EXPECT_EQ(classify(ROWS[0], bounds, {}), Judgement::order_dependent);
    EXPECT_EQ(classify(ROWS[2], bounds, {}), Judgement::order_dependent);
}

TEST(Advice, ATieOfTimesGoesToFewerBits) {
    std::vector<ChartRow> rows = {row_of("power8-32", 10, 288, 0.01, 2),
                                  row_of("power4-32", 11, 160, 0.01, 1), row_of("wboit", 12, 64, 0.01, 1)};
    EXPECT_EQ(advise(rows, error_of_at_most(0.02), unknown(rows)).winner, Row(1))
        << "wboit is clearly slower";
    EXPECT_EQ(advise(rows, error_of_at_most(0.02), unknown(rows)).runner_up, Row(0));
    for (ChartRow& row : rows) row.numbers->total.range = 0;
    EXPECT_EQ(advise(rows, error_of_at_most(0.02), unknown(rows)).winner, Row(0));
    rows = {row_of("power8-32", 10, std::nullopt, 0.01), row_of("power4-32", 10, 160, 0.01)};
    EXPECT_EQ(advise(rows, error_of_at_most(0.02), unknown(rows)).winner, Row(1))
        << "bits that grow are most";
}

TEST(Advice, TheErrorHasToHoldAtOtherViews) {
    HeldOutErrors held_out = unknown();
    held_out[2] = 0.06;  // more than allowed, but only at a held-out view
    const Advice advice = advise(ROWS, error_of_at_most(0.05), held_out);
    EXPECT_EQ(advice.winner, Row(3));
    EXPECT_EQ(classify(ROWS[2], error_of_at_most(0.05), held_out[2]), Judgement::inaccurate_elsewhere);
    EXPECT_EQ(worst_error(ROWS[2], Metric::rmse, held_out[2]), 0.06);
    EXPECT_EQ(worst_error(ROWS[2], Metric::rmse, 0.001), 0.02);
    held_out[2] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(classify(ROWS[2], error_of_at_most(0.01), held_out[2]), Judgement::meets);
}

TEST(Advice, WhateverIsNamedWasChecked) {
    HeldOutErrors held_out = unknown();
    std::vector<std::size_t> asked;
    const auto check = [&](std::size_t row) {
        asked.push_back(row);
        return Row(row) == Row(2) ? std::optional(0.5)
                                  : std::optional(error_of(*ROWS[row].numbers, Metric::rmse));
    };
    const auto advice = checked_advice(ROWS, error_of_at_most(0.05), held_out, check);
    ASSERT_TRUE(advice);
    EXPECT_EQ(asked, (std::vector<std::size_t>{2, 3, 4}));
    EXPECT_EQ(advice->winner, Row(3));
    EXPECT_EQ(advice->runner_up, Row(4));
    EXPECT_EQ(unchecked(*advice, held_out), std::nullopt);
    held_out = unknown();
    EXPECT_FALSE(checked_advice(ROWS, error_of_at_most(0.05), held_out, [](std::size_t) {
        return std::optional<double>();
    })) << "stopped";
}

TEST(Advice, WhenNothingMeetsTheNearestMissesLeast) {
    AdviceBounds bounds = error_of_at_most(0.004);
    Advice advice = advise(ROWS, bounds, unknown());
    EXPECT_EQ(advice.winner, std::nullopt);
    EXPECT_EQ(advice.nearest, Row(4));
    EXPECT_EQ(advice.ground_truths, std::vector<std::size_t>{5});
    std::string text = no_advice_text(ROWS, bounds, unknown(), advice);
    expect_one_sentence(text);
    EXPECT_NE(text.find("Only a ground truth"), std::string::npos) << text;
    EXPECT_NE(text.find("sorted at 20.0 ms"), std::string::npos) << text;
    EXPECT_NE(text.find("power8-32"), std::string::npos) << text;
    bounds.max_bits = 250;  // a ground truth exceeds this
    advice = advise(ROWS, bounds, unknown());
    EXPECT_TRUE(advice.ground_truths.empty());
    EXPECT_EQ(advice.nearest, Row(4)) << "1.25 times too wrong and 1.15 times too large";
    text = no_advice_text(ROWS, bounds, unknown(), advice);
    expect_one_sentence(text);
    EXPECT_TRUE(
        text.starts_with("Nothing meets these bounds (RMSE at most 0.004, at most 250 bits per pixel)"))
        << text;
    EXPECT_NE(text.find("the nearest is power8-32 (RMSE 0.005, 10.0 ms, 288 bits per pixel)"),
              std::string::npos)
        << text;
}

// The maximum of numbers and NaN must not hide the NaN.
TEST(Advice, InfinitePicturesElsewhereAreToldAsSuch) {
    const AdviceBounds bounds = error_of_at_most(0.05);
    for (const double none : {std::numeric_limits<double>::infinity(), std::nan("")}) {
        EXPECT_FALSE(worst_error(ROWS[4], Metric::rmse, none) < 1e300);
        EXPECT_EQ(classify(ROWS[4], bounds, none), Judgement::infinite_elsewhere);
        HeldOutErrors held_out = unknown();
        held_out[4] = none;
        const Advice advice = advise(ROWS, bounds, held_out);
        ASSERT_TRUE(advice.winner);
        EXPECT_NE(advice.winner, Row(4));
        const std::string text = advice_text(ROWS, bounds, held_out, advice);
        EXPECT_NE(text.find("infinite  infinite pixels elsewhere"), std::string::npos) << text;
    }
}

TEST(Advice, OfGroundTruthsAloneThereIsNone) {
    const std::vector<ChartRow> rows = {ROWS[5]};
    const AdviceBounds bounds = error_of_at_most(0.1);
    const Advice advice = advise(rows, bounds, unknown(rows));
    EXPECT_EQ(advice.winner, std::nullopt);
    EXPECT_EQ(advice.nearest, std::nullopt);
    expect_one_sentence(no_advice_text(rows, bounds, unknown(rows), advice));
    expect_one_sentence(no_advice_text({}, bounds, {}, advise({}, bounds, {})));
}

TEST(Advice, OtherMetricsAreOtherNumbers) {
    AdviceBounds bounds = error_of_at_most(0.05);
    bounds.metric = Metric::flip;
    EXPECT_EQ(advise(ROWS, bounds, unknown()).winner, Row(2));
    bounds.max_error = 0.03;
    EXPECT_EQ(advise(ROWS, bounds, unknown()).winner, Row(4));
    bounds.metric = Metric::delta_e;
    bounds.max_error = 2;
    EXPECT_EQ(advise(ROWS, bounds, unknown()).winner, Row(2));
}

TEST(Advice, TheTextHasRolesAndEvidence) {
    HeldOutErrors held_out = unknown();
    for (const std::size_t i : {2U, 3U, 4U}) held_out[i] = 0.003;
    const AdviceBounds bounds = error_of_at_most(0.05);
    const Advice advice = advise(ROWS, bounds, held_out);
    const std::string text = advice_text(ROWS, bounds, held_out, advice);
    EXPECT_NE(text.find("Cheapest     at (RMSE 0.02, 4.0 ms, 320 bits per pixel)"), std::string::npos)
        << text;
    EXPECT_NE(
        text.find("power8-32 (RMSE 0.005, 10.0 ms, 288 bits per pixel): half the error for 6.0 ms more"),
        std::string::npos)
        << text;
    EXPECT_NE(text.find("error too great\n"), std::string::npos) << text;
    const auto evidence = evidence_of(ROWS, bounds, held_out, advice, 6);
    EXPECT_TRUE(std::ranges::is_sorted(evidence));
    EXPECT_LE(evidence.size(), 9U);
}

TEST(Advice, BoundsThatMakeNoSenseAreRefused) {
    constexpr double NONE = std::numeric_limits<double>::quiet_NaN();
    for (const double error : {0.0, -1.0, NONE, std::numeric_limits<double>::infinity()})
        expect_error([&] { require_sensible(error_of_at_most(error)); }, "give a number above 0");
    AdviceBounds bounds = error_of_at_most(1);
    bounds.metric = Metric::flip;
    expect_error([&] { require_sensible(bounds); }, "never above 1");
    bounds = error_of_at_most(0.1);
    bounds.max_bits = 0;
    expect_error([&] { require_sensible(bounds); }, "at least 1");
    bounds.max_bits.reset();
    for (const double ms : {0.0, -2.0, NONE}) {
        bounds.max_ms = ms;
        expect_error([&] { require_sensible(bounds); }, "above 0 milliseconds");
    }
    require_sensible(error_of_at_most(0.1));
}

}  // namespace
