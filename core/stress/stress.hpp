// stress.hpp -- techniques times conditions: how often a reconstruction fails, and by how much it is off.
#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <vector>

#include "core/stress/condition.hpp"
#include "core/stress/classify.hpp"
#include "core/table/run_table.hpp"

namespace momentscope {

/// What many random rays under one condition did to one technique. Errors are of T at fragments' own depths
/// and at two random ones.
struct StressCell {
    const Technique* technique = nullptr;
    const Condition* condition = nullptr;
    long rays = 0, queries = 0;

    // Failures: a result that is no number, or, before it is clamped, outside [0, b0], or whose T is off by
    // more than FAILED_ERROR from the exact result at the same alpha.
    long not_numbers = 0, outside = 0, inaccurate = 0;

    // Beside them, what is no failure: how often the solver raised a pivot to its floor, and a sum left [0,
    // 1] by rounding.
    long floored = 0, clamped = 0;

    long non_monotone = 0;  // rays whose curve falls somewhere by more than 1e-3 b0
    long truth_outside =
        0;  // queries whose truth leaves what beta = 0 and beta = 1 give, by more than 1e-3 b0
    long order_dependent =
        0;  // rays whose T changes by more than 1/255 when fragments are submitted in another order

    double mean = 0, percentile_99 = 0, worst = 0;  // |T - exact T| at the same alpha
    double mean_from_truth = 0;                     // |T - true T| at fragments' own depths
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
    int rays = 400;  // per cell; fewer where they have many fragments
    std::uint32_t seed = 1;
    Shard shard = {};  // of the cells, technique by technique
};

/// The rays of one cell. Depends on the options alone, whichever thread runs it, unless
/// it is stopped.
StressCell stress_cell(const Technique& technique, const Condition& condition, const StressOptions& options,
                       const std::stop_token& stop = {});

/// All cells of the shard, technique by technique, on all cores. `progress` is called by any thread with how
/// many are done; a stop leaves the result empty.
std::vector<StressCell> run_stress(const StressOptions& options, std::stop_token stop,
                                   const std::function<void(std::size_t done, std::size_t all)>& progress);

}  // namespace momentscope
