// advice.hpp -- chooses the cheapest technique that meets given bounds, from the rows of a chart.
#pragma once
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/chart/chart.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// The bounds that a user sets. They are inclusive.
struct AdviceBounds {
    double max_error = 0.01;  // in the unit of the metric
    Metric metric = Metric::rmse;
    std::optional<int> max_bits = {};   // per pixel, without the colour buffers
    std::optional<double> max_ms = {};  // total time of the passes of a technique
    bool order_independent = false;     // the order of submission must not change the picture
    friend bool operator==(const AdviceBounds&, const AdviceBounds&) = default;
};

/// Throws Error if a bound is NaN, is not above 0, or excludes nothing.
void require_sensible(const AdviceBounds& bounds);

/// For each row, the greatest error at views at which the row was not measured; infinite if a picture there
/// has infinite colours; nullopt if unknown.
using HeldOutErrors = std::vector<std::optional<double>>;

/// Why a row is not the advice. The first reason that applies counts.
enum class Judgement {
    meets,
    unavailable,         // the GL cannot draw it, or this version does not have it
    ground_truth,        // a reference, not a candidate
    order_dependent,     // and the bounds exclude that
    infinite_elsewhere,  // pixels at held-out views are infinite or NaN
    inaccurate,
    inaccurate_elsewhere,  // only at held-out views
    too_many_bits,
    too_slow,
};

/// The advice, as indices of rows. Without a winner there is a nearest row, if any row is a candidate.
struct Advice {
    std::optional<std::size_t> winner;
    std::optional<std::size_t> runner_up;    // would win if the winner did not exist
    std::optional<std::size_t> next_better;  // cheapest with half the error or less; no other bounds
    std::optional<std::size_t> nearest;      // smallest factor over the bound that it misses most
    std::vector<std::size_t> ground_truths;  // those that meet the bounds, if nothing else does
    friend bool operator==(const Advice&, const Advice&) = default;
};

/// The technique of a row; nullptr if this version has none with this id.
const Technique* technique_of(const ChartRow& row);

/// The error of a row that has numbers: at its own view or at held-out views, whichever is greater.
double worst_error(const ChartRow& row, Metric metric, const std::optional<double>& held_out);

Judgement classify(const ChartRow& row, const AdviceBounds& bounds, const std::optional<double>& held_out);

/// Chooses among the rows of one scene. The winner has the least total time of all rows that meet the bounds.
/// Times count as equal if their quartile ranges overlap; then the fewest bits win, then the least time.
/// `held_out` has one element per row.
Advice advise(std::span<const ChartRow> rows, const AdviceBounds& bounds, const HeldOutErrors& held_out);

/// The first row in the advice with an unknown error at held-out views; nullopt if there is none. When this
/// error is known, the advice may change.
std::optional<std::size_t> unchecked(const Advice& advice, const HeldOutErrors& held_out);

/// Advice with every row checked. check(row) returns the error at held-out views, or nullopt to stop; then
/// the result is nullopt, too. `held_out` keeps all errors that were found.
std::optional<Advice> checked_advice(std::span<const ChartRow> rows, const AdviceBounds& bounds,
                                     HeldOutErrors& held_out,
                                     const std::function<std::optional<double>(std::size_t row)>& check);

}  // namespace momentscope
