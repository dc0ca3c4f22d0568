// tune.hpp -- the moment bias, wrapping zone and overestimation weight of least error for given rays.
#pragma once
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/parameters.hpp"
#include "core/ray/random_ray.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// One value that was tried, and what all rays made of it. Moment biases are judged at beta = 0, where no
/// fragment occludes itself: at other beta this outweighs what bias does.
struct Trial {
    ParameterId parameter;
    float value = 0;
    double error = 0;          // root mean square of T - true T at the fragments' own depths
    double failure_rate = 0;   // of queries, as in classify.hpp
    double inherent_rate = 0;  // of queries that exact arithmetic on the stored moments would fail, too, or
                               // whose rounded moments leave nothing to reconstruct
};

struct TuneOptions {
    const Technique* technique = nullptr;
    ParameterValues values;       // where the search begins; the solver is taken from here
    double most_failures = 1e-3;  // a moment bias with a higher failure rate is not safe
};

struct TuneResult {
    ParameterValues values;
    double error = 0, failure_rate = 0;  // with them
    double error_before = 0;             // with TuneOptions::values
    bool safe = true;                    // false: no moment bias kept the failure rate below most_failures
    std::vector<Trial> trials;           // in the order in which they were made
};

/// Tries moment biases from 1e-9 to 0.1, four to a decade, and those of the presets, and takes the largest
/// safe one within ENOUGH of the least error, because what bias costs nothing keeps a scene's hardest pixels
/// safe; then tries theta (where the technique has it) and beta. Rays without fragments are left out; throws
/// Error when none is left, and when the technique has no moments. nullopt after a stop.
std::optional<TuneResult> tune(const std::vector<ViewRay>& rays, const TuneOptions& options,
                               std::stop_token stop,
                               const std::function<void(std::size_t done, std::size_t all)>& progress);

/// The smallest moment bias from which on all that were tried are safe; nullopt when not even the greatest
/// is.
std::optional<float> least_safe_bias(const TuneResult& result, double most_failures);

constexpr double MAX_RELATIVE_LOSS = 1.01;  // times the least error of a safe bias

/// The moment bias by overdraw: rays of 2, 4, ... 1024 thin fragments in two layers, where the matrix of
/// moments is nearly singular however many they are. Up to `rays` of them for each count.
struct OverdrawTrial {
    int fragments;
    TuneResult result;
};
std::optional<std::vector<OverdrawTrial>> tune_by_overdraw(
    const TuneOptions& options, int rays, std::uint32_t seed, std::stop_token stop,
    const std::function<void(std::size_t done, std::size_t all)>& progress);

/// `count` random rays of 2 to 5 fragments, the range in which moments decide.
std::vector<ViewRay> tuning_rays(int count, std::uint32_t seed);

}  // namespace momentscope
