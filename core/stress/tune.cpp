#include "core/stress/tune.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/stress/tuning_attempt.hpp"
#include "core/support/error.hpp"

namespace momentscope {

namespace {

std::vector<float> candidates(ParameterId id, const Technique& technique) {
    std::vector<float> values;
    if (id != ParameterId::alpha) {
        for (int i = 0; i <= 20; ++i) values.push_back(static_cast<float>(i) * 0.05f);
        return values;
    }
    for (int i = -36; i <= -4; ++i) values.push_back(std::pow(10.0f, static_cast<float>(i) / 4));
    values.insert(values.end(), {technique.moments().recommended_bias,
                                 technique.moments().robust_bias});  // the presets, for comparison
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

// Sums over threads differ between machines in their last digits. A value must be better by more than this.
constexpr double WINS_BY = 1 - 1e-9;

const Trial* least_error(const std::vector<Trial>& trials, ParameterId id, double most_failures) {
    const Trial* best = nullptr;
    for (const Trial& trial : trials)
        if (trial.parameter == id && trial.failure_rate <= most_failures &&
            (best == nullptr || trial.error < best->error * WINS_BY))
            best = &trial;
    return best;
}

// The largest safe bias whose error is within MAX_RELATIVE_LOSS of the least error.
const Trial* best_bias(const std::vector<Trial>& trials, double most_failures) {
    const Trial* best = least_error(trials, ParameterId::alpha, most_failures);
    if (best == nullptr) return nullptr;
    const double enough = best->error * MAX_RELATIVE_LOSS;
    for (const Trial& trial : trials)
        if (trial.failure_rate <= most_failures && trial.error <= enough && trial.value > best->value)
            best = &trial;
    return best;
}

void require_tunable(const Technique& technique, const std::vector<ViewRay>& rays) {
    if (!technique.has_moments())
        throw Error(
            fmt::format("'{}' has no parameters to tune; choose a technique with moments.", technique.id));
    if (rays.empty())
        throw Error(
            "No ray has a transparent fragment, so there is nothing to tune; choose another scene or ray.");
}

// In the order in which they are tuned. The expected T does not depend on beta.
std::vector<ParameterId> tuned_parameters(const Technique& technique, const ParameterValues& values) {
    std::vector<ParameterId> ids = {ParameterId::alpha};
    if (technique.uses(ParameterId::theta)) ids.push_back(ParameterId::theta);
    if (resolve(values, technique).estimation.estimate != Estimate::expected)
        ids.push_back(ParameterId::beta);
    return ids;
}

}  // namespace

Sliced<std::optional<TuneResult>> tune_in_parts(std::vector<ViewRay> rays, TuneOptions options,
                                                std::stop_token stop, TuneProgress progress) {
    const Technique& technique = *options.technique;
    std::erase_if(rays, [](const ViewRay& ray) { return ray.fragments.empty(); });
    require_tunable(technique, rays);
    const std::vector<ParameterId> ids = tuned_parameters(technique, options.values);
    std::size_t trials = 2, done = 0;
    for (const ParameterId id : ids) trials += candidates(id, technique).size();

    TuneResult result;
    result.values = options.values;
    TuningAttempt first(rays, technique, options.values, false);
    co_await first.parts(stop);
    progress(++done, trials);
    result.error_before = first.trial(ParameterId::alpha, 0).error;
    for (const ParameterId id : ids) {
        for (const float value : candidates(id, technique)) {
            ParameterValues values = result.values;
            values.set(id, value);
            if (id == ParameterId::alpha) values.set(ParameterId::beta, 0.0f);
            TuningAttempt attempt(rays, technique, values, id == ParameterId::alpha);
            co_await attempt.parts(stop);
            if (stop.stop_requested()) co_return std::nullopt;
            progress(++done, trials);
            result.trials.push_back(attempt.trial(id, value));
        }
        const Trial* best = id == ParameterId::alpha ? best_bias(result.trials, options.most_failures)
                                                     : least_error(result.trials, id, 1.0);
        if (best == nullptr) {  // no bias is safe; take the one with the least failures
            result.safe = false;
            best = &*std::ranges::min_element(result.trials, {}, &Trial::failure_rate);
        }
        result.values.set(id, best->value);
    }
    TuningAttempt last(rays, technique, result.values, true);
    co_await last.parts(stop);
    if (stop.stop_requested()) co_return std::nullopt;
    progress(++done, trials);
    const Trial of_result = last.trial(ParameterId::alpha, *result.values[ParameterId::alpha]);
    result.error = of_result.error;
    result.failure_rate = of_result.failure_rate;
    co_return result;
}

std::optional<TuneResult> tune(const std::vector<ViewRay>& rays, const TuneOptions& options,
                               std::stop_token stop, const TuneProgress& progress) {
    return tune_in_parts(rays, options, std::move(stop), progress).finish();
}

std::optional<float> least_safe_bias(const TuneResult& result, double most_failures) {
    std::optional<float> least;
    for (const Trial& trial : result.trials) {  // biases ascend
        if (trial.parameter != ParameterId::alpha) continue;
        if (trial.failure_rate > most_failures)
            least.reset();
        else if (!least)
            least = trial.value;
    }
    return least;
}

std::optional<std::vector<OverdrawTrial>> tune_by_overdraw(const TuneOptions& options, int count,
                                                           std::uint32_t seed, const std::stop_token& stop,
                                                           const TuneProgress& progress) {
    std::vector<OverdrawTrial> trials;
    constexpr int DOUBLINGS = 10;
    for (int k = 1; k <= DOUBLINGS; ++k) {
        const int fragments = 1 << k;
        RandomNumbers random(seed + static_cast<std::uint32_t>(k));
        std::vector<ViewRay> rays;
        // Take fewer rays if they have more fragments, so that each step takes about the same time.
        for (int i = 0; i < std::max(count * 16 / std::max(fragments, 16), 20); ++i)
            rays.push_back(layered_ray(random, fragments));
        auto result = tune(rays, options, stop, [&](std::size_t done, std::size_t all) {
            progress(static_cast<std::size_t>(k - 1) * all + done, DOUBLINGS * all);
        });
        if (!result) return std::nullopt;
        trials.push_back({fragments, std::move(*result)});
    }
    return trials;
}

std::vector<ViewRay> tuning_rays(int count, std::uint32_t seed) {
    RandomNumbers random(seed);
    std::vector<ViewRay> rays;
    for (int i = 0; i < count; ++i) rays.push_back(random_ray(random, random.whole(2, 5)));
    return rays;
}

}  // namespace momentscope
