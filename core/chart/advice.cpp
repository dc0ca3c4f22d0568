#include "core/chart/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/support/error.hpp"

namespace momentscope {

namespace {

constexpr double NEVER = std::numeric_limits<double>::infinity();
constexpr double CLEARLY_BETTER = 0.5;  // of the error of the winner

using Indices = std::vector<std::size_t>;

double bits_of(const ChartRow& row) {
    return row.numbers->bits_with_factor ? *row.numbers->bits_with_factor : NEVER;
}

double time_of(const ChartRow& row) {
    return row.numbers->total.median;
}

bool may_be_advised(Judgement judgement) {
    return judgement != Judgement::unavailable && judgement != Judgement::ground_truth &&
           judgement != Judgement::order_dependent;
}

bool fits(const ChartRow& row, const AdviceBounds& bounds, double error) {
    return error <= bounds.max_error && (!bounds.max_bits || bits_of(row) <= *bounds.max_bits) &&
           (!bounds.max_ms || time_of(row) <= *bounds.max_ms);
}

// Compares medians. They count as equal if they differ by less than half the sum of their ranges.
bool as_fast(const ChartRow& row, const ChartRow& fastest) {
    return time_of(row) - time_of(fastest) <= 0.5 * (row.numbers->total.range + fastest.numbers->total.range);
}

std::optional<std::size_t> cheapest(std::span<const ChartRow> rows, const Indices& among) {
    if (among.empty()) return std::nullopt;
    const auto time = [&](std::size_t i) { return std::pair(time_of(rows[i]), i); };
    const std::size_t fastest = *std::ranges::min_element(among, {}, time);
    Indices equal;
    for (const std::size_t i : among)
        if (as_fast(rows[i], rows[fastest])) equal.push_back(i);
    return *std::ranges::min_element(
        equal, {}, [&](std::size_t i) { return std::tuple(bits_of(rows[i]), time_of(rows[i]), i); });
}

/// The factor by which a row exceeds the bound that it misses most.
double excess(const ChartRow& row, const AdviceBounds& bounds, double error) {
    double most = error / bounds.max_error;
    if (bounds.max_bits) most = std::max(most, bits_of(row) / *bounds.max_bits);
    if (bounds.max_ms) most = std::max(most, time_of(row) / *bounds.max_ms);
    return most;
}

}  // namespace

void require_sensible(const AdviceBounds& bounds) {
    const MetricRow& metric = metrics()[static_cast<std::size_t>(bounds.metric)];
    if (!std::isfinite(bounds.max_error) || !(bounds.max_error > 0))
        throw Error(fmt::format("Only the ground truth has an error of at most {:g}; give a number above 0.",
                                bounds.max_error));
    if (bounds.metric == Metric::flip && bounds.max_error >= 1)
        throw Error(fmt::format("{} is never above 1, so {:g} limits nothing; give a number below 1.",
                                metric.symbol, bounds.max_error));
    if (bounds.max_bits && *bounds.max_bits < 1)
        throw Error(
            fmt::format("Nothing can be stored in {} bits per pixel; give at least 1.", *bounds.max_bits));
    if (bounds.max_ms && (!std::isfinite(*bounds.max_ms) || !(*bounds.max_ms > 0)))
        throw Error(fmt::format("Nothing can be drawn in {:g} ms; give a time above 0 milliseconds.",
                                *bounds.max_ms));
}

const Technique* technique_of(const ChartRow& row) {
    return find_technique(std::string_view(row.configuration).substr(0, row.configuration.find(':')));
}

double worst_error(const ChartRow& row, Metric metric, const std::optional<double>& held_out) {
    assert(row.numbers);
    const double elsewhere = held_out.value_or(0);
    if (std::isnan(elsewhere)) return elsewhere;  // std::max would ignore NaN
    return std::max(error_of(*row.numbers, metric), elsewhere);
}

Judgement classify(const ChartRow& row, const AdviceBounds& bounds, const std::optional<double>& held_out) {
    const Technique* technique = technique_of(row);
    if (technique == nullptr || !row.numbers) return Judgement::unavailable;
    if (technique->is_truth()) return Judgement::ground_truth;
    // Techniques that blend in the order of submission are excluded, whatever their rows say.
    if (bounds.order_independent &&
        (technique->order_dependent || std::string_view(technique->id) == "unsorted"))
        return Judgement::order_dependent;
    if (held_out && !std::isfinite(*held_out)) return Judgement::infinite_elsewhere;
    // Written so that NaN meets no bound.
    if (!(error_of(*row.numbers, bounds.metric) <= bounds.max_error)) return Judgement::inaccurate;
    if (!(worst_error(row, bounds.metric, held_out) <= bounds.max_error))
        return Judgement::inaccurate_elsewhere;
    if (bounds.max_bits && bits_of(row) > *bounds.max_bits) return Judgement::too_many_bits;
    if (bounds.max_ms && time_of(row) > *bounds.max_ms) return Judgement::too_slow;
    return Judgement::meets;
}

Advice advise(std::span<const ChartRow> rows, const AdviceBounds& bounds, const HeldOutErrors& held_out) {
    assert(held_out.size() == rows.size());
    const auto error = [&](std::size_t i) { return worst_error(rows[i], bounds.metric, held_out[i]); };
    Advice advice;
    Indices candidates, meeting;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Judgement judgement = classify(rows[i], bounds, held_out[i]);
        if (may_be_advised(judgement)) candidates.push_back(i);
        if (judgement == Judgement::meets) meeting.push_back(i);
    }
    advice.winner = cheapest(rows, meeting);
    if (!advice.winner) {
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (classify(rows[i], bounds, held_out[i]) == Judgement::ground_truth &&
                fits(rows[i], bounds, error(i)))
                advice.ground_truths.push_back(i);
        if (!candidates.empty())
            advice.nearest = *std::ranges::min_element(candidates, {}, [&](std::size_t i) {
                return std::tuple(excess(rows[i], bounds, error(i)), time_of(rows[i]), i);
            });
        return advice;
    }
    std::erase(meeting, *advice.winner);
    advice.runner_up = cheapest(rows, meeting);
    std::erase_if(candidates, [&](std::size_t i) {
        return i == *advice.winner || !(error(i) <= CLEARLY_BETTER * error(*advice.winner));
    });
    advice.next_better = cheapest(rows, candidates);
    return advice;
}

std::optional<std::size_t> unchecked(const Advice& advice, const HeldOutErrors& held_out) {
    for (const auto& row : {advice.winner, advice.runner_up, advice.next_better, advice.nearest})
        if (row && !held_out[*row]) return row;
    return std::nullopt;
}

std::optional<Advice> checked_advice(std::span<const ChartRow> rows, const AdviceBounds& bounds,
                                     HeldOutErrors& held_out,
                                     const std::function<std::optional<double>(std::size_t row)>& check) {
    for (;;) {  // ends, because each turn except the last checks another row
        Advice advice = advise(rows, bounds, held_out);
        const std::optional<std::size_t> row = unchecked(advice, held_out);
        if (!row) return advice;
        held_out[*row] = check(*row);
        if (!held_out[*row]) return std::nullopt;
    }
}

}  // namespace momentscope
