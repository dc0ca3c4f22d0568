// stress.hpp -- tests techniques under conditions: how often a reconstruction fails, and how large its error
// is.
#pragma once
#include <cstdint>
#include <functional>
#include <stop_token>
#include <vector>

#include "core/stress/classify.hpp"
#include "core/stress/condition.hpp"
#include "core/support/sliced.hpp"
#include "core/table/run_table.hpp"

namespace momentscope {

/// The results of one technique under one condition, over many random rays. Errors are those of T at the
/// depths of fragments and at two random depths.
struct StressCell {
    const Technique* technique = nullptr;
    const Condition* condition = nullptr;
    long rays = 0, queries = 0;

    // Failures: a result is NaN, or lies outside [0, b0] before it is clamped, or its T differs by more than
    // FAILED_ERROR from the exact result at the same alpha.
    long not_numbers = 0, outside = 0, inaccurate = 0;

    // These are not failures: rays for which the solver raised a pivot to its floor, and sums that left [0,
    // 1] by rounding.
    long floored = 0, clamped = 0;

    long non_monotone = 0;     // rays whose curve falls somewhere by more than 1e-3 b0
    long truth_outside = 0;    // queries whose truth is outside of beta = 0 to beta = 1 by more than 1e-3 b0
    long order_dependent = 0;  // rays whose T changes by more than 1/255 in another order

    double mean = 0, percentile_99 = 0, worst = 0;  // |T - exact T| at the same alpha
    double mean_from_truth = 0;                     // |T - true T| at the depths of fragments
    StressCase worst_case;                          // of the worst query

    long failures() const { return not_numbers + outside + inaccurate; }
    double failure_rate() const {
        return queries == 0 ? 0 : static_cast<double>(failures()) / static_cast<double>(queries);
    }
};

struct StressOptions {
    std::vector<const Technique*> techniques;
    std::vector<const Condition*> conditions;
    ParameterValues values;
    int rays = 400;  // per cell; fewer if they have many fragments
    std::uint32_t seed = 1;
    Shard shard = {};  // of the cells, technique by technique
};

/// Runs one cell. The result depends only on the options, whichever thread runs it, unless it is stopped.
StressCell stress_cell(const Technique& technique, const Condition& condition, const StressOptions& options,
                       const std::stop_token& stop = {});

using StressProgress = std::function<void(std::size_t done, std::size_t all)>;

/// Runs all cells of the shard, technique by technique; a cell is a part. `progress` is called by any thread
/// with the number of finished cells. If stopped, the result is empty.
Sliced<std::vector<StressCell>> stress_in_parts(StressOptions options, std::stop_token stop,
                                                StressProgress progress);

/// The same to the end, on all cores.
std::vector<StressCell> run_stress(const StressOptions& options, std::stop_token stop,
                                   const StressProgress& progress);

}  // namespace momentscope
