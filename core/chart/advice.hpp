// advice.hpp -- the cheapest technique that meets bounds, from the rows of a chart.
#pragma once
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/chart/chart.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// What somebody needs. Limits are inclusive.
struct AdviceBounds {
    double max_error = 0.01;  // in the metric's own unit
    Metric metric = Metric::rmse;
    std::optional<int> max_bits = {};   // per pixel, beside the colour buffers
    std::optional<double> max_ms = {};  // total of a technique's passes
    bool order_independent = false;     // the order of submission must not change the picture
    friend bool operator==(const AdviceBounds&, const AdviceBounds&) = default;
};

/// Throws Error when a bound is no number, is not above 0, or bounds nothing.
void require_sensible(const AdviceBounds& bounds);

/// For each row the greatest error at views at which the rows were not measured, infinite where a picture is;
/// nullopt where it is unknown.
using HeldOutErrors = std::vector<std::optional<double>>;

/// What stands between a row and the advice, first things first.
enum class Judgement {
    meets,
    unavailable,         // the GL cannot draw it, or this version does not know it
    ground_truth,        // a reference, not a candidate
    order_dependent,     // and that was ruled out
    infinite_elsewhere,  // pixels at views that are held out are infinite or NaN
    inaccurate,
    inaccurate_elsewhere,  // at views that are held out alone
    too_many_bits,
    too_slow,
};

/// Indices of rows. Without a winner there is a nearest one, if any row is a candidate.
struct Advice {
    std::optional<std::size_t> winner;
    std::optional<std::size_t> runner_up;  // what the winner would be without the winner
    std::optional<std::size_t>
        next_better;                     // the cheapest of half the winner's error; bits and time are free
    std::optional<std::size_t> nearest;  // exceeds the bound that it misses most by the least factor
    std::vector<std::size_t> ground_truths;  // that meet the bounds when nothing else does
    friend bool operator==(const Advice&, const Advice&) = default;
};

/// The technique of a row; nullptr when this version has none of that id.
const Technique* technique_of(const ChartRow& row);

/// The error of a row with numbers: of its own view or of those held out, whichever is greater.
double worst_error(const ChartRow& row, Metric metric, const std::optional<double>& held_out);

Judgement classify(const ChartRow& row, const AdviceBounds& bounds, const std::optional<double>& held_out);

/// The winner has the least total time of the rows that meet the bounds. Times whose quartiles overlap are
/// equal; then the fewest bits win, then the least time. `rows` are those of one scene, `held_out` is as
/// long.
Advice advise(std::span<const ChartRow> rows, const AdviceBounds& bounds, const HeldOutErrors& held_out);

/// The first row that the advice names and whose error at held-out views is unknown; nullopt when there is
/// none. Once that error is known, the advice may be another.
std::optional<std::size_t> unchecked(const Advice& advice, const HeldOutErrors& held_out);

/// Advice of which every row was checked: `check(row)` is the error at held-out views, or nullopt to stop;
/// then nullopt is returned. `held_out` keeps what was found.
std::optional<Advice> checked_advice(std::span<const ChartRow> rows, const AdviceBounds& bounds,
                                     HeldOutErrors& held_out,
                                     const std::function<std::optional<double>(std::size_t row)>& check);

}  // namespace momentscope
