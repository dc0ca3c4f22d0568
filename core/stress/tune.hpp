// tune.hpp -- finds the moment bias, wrapping zone and overestimation weight with the least error for given
// rays.
#pragma once
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/parameters/parameters.hpp"
#include "core/ray/random_ray.hpp"
#include "core/support/sliced.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// One value that was tried, with the results over all rays. Moment biases are tried at beta = 0, where no
/// fragment occludes itself. At other beta, self-occlusion would outweigh the effect of the bias.
struct Trial {
    ParameterId parameter;
    float value = 0;
    double error = 0;          // root mean square of T - true T at the depths of fragments
    double failure_rate = 0;   // share of queries that fail (classify.hpp)
    double inherent_rate = 0;  // share that fails in exact arithmetic on the stored moments, too, or for
                               // which rounding made their matrix singular
};

struct TuneOptions {
    const Technique* technique = nullptr;
    ParameterValues values;       // the start of the search; the solver is taken from it
    double most_failures = 1e-3;  // a moment bias with a higher failure rate is not safe
};

struct TuneResult {
    ParameterValues values;
    double error = 0, failure_rate = 0;  // with these values
    double error_before = 0;             // with TuneOptions::values
    bool safe = true;                    // false: no moment bias kept the failure rate below most_failures
    std::vector<Trial> trials;           // in the order in which they were made
};

using TuneProgress = std::function<void(std::size_t done, std::size_t all)>;

/// Tries moment biases from 1e-9 to 0.1, four per decade, and those of the presets. Takes the largest safe
/// one whose error is at most MAX_RELATIVE_LOSS times the least error: bias that costs almost nothing keeps
/// the hardest pixels of a scene safe. Then tries theta (if the technique has it) and beta. Rays without
/// fragments are left out. Throws Error if no ray is left, or if the technique has no moments. nullopt if
/// stopped.
std::optional<TuneResult> tune(const std::vector<ViewRay>& rays, const TuneOptions& options,
                               std::stop_token stop, const TuneProgress& progress);

/// The same in parts, which are a few rays each.
Sliced<std::optional<TuneResult>> tune_in_parts(std::vector<ViewRay> rays, TuneOptions options,
                                                std::stop_token stop, TuneProgress progress);

/// The smallest moment bias such that it and all greater ones that were tried are safe; nullopt if not even
/// the greatest is safe.
std::optional<float> least_safe_bias(const TuneResult& result, double most_failures);

constexpr double MAX_RELATIVE_LOSS = 1.01;  // error allowed, relative to the least error of a safe bias

/// Finds the moment bias as a function of overdraw. Rays have 2, 4, ..., 1024 thin fragments in two layers,
/// so the matrix of moments is nearly singular, whatever their number. At most `rays` rays are used for each
/// number of fragments.
struct OverdrawTrial {
    int fragments;
    TuneResult result;
};
std::optional<std::vector<OverdrawTrial>> tune_by_overdraw(const TuneOptions& options, int rays,
                                                           std::uint32_t seed, const std::stop_token& stop,
                                                           const TuneProgress& progress);

/// `count` random rays of 2 to 5 fragments, the range in which moments matter.
std::vector<ViewRay> tuning_rays(int count, std::uint32_t seed);

}  // namespace momentscope
