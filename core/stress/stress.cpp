#include "core/stress/stress.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "core/inspect/exact_estimates.hpp"
#include "core/inspect/fragment_estimates.hpp"
#include "core/stress/classify.hpp"
#include "core/techniques/moment_kernel.hpp"

namespace momentscope {

namespace {

constexpr std::size_t CURVE_SAMPLES = 65;
constexpr int RANDOM_DEPTHS = 2;
constexpr double VISIBLE = 1.0 / 255;

ViewRay shuffled(const ViewRay& ray, RandomNumbers& random) {
    ViewRay result = ray;
    for (std::size_t i = result.fragments.size(); i > 1; --i)
        std::swap(result.fragments[i - 1],
                  result.fragments[static_cast<std::size_t>(random.whole(0, static_cast<int>(i) - 1))]);
    return result;
}

// The fractions of one pixel at many depths.
std::vector<float> fractions_at(std::span<const float> depths, const MomentVector& stored,
                                const MomentKernel& kernel, const ReconstructionSettings& settings) {
    std::vector<float> fractions(depths.size());
    kernel.fractions(std::vector<MomentVector>(depths.size(), stored), settings, depths, fractions);
    return fractions;
}

ReconstructionSettings with_overestimation(ReconstructionSettings settings, float beta) {
    settings.overestimation = beta;
    return settings;
}

class CellRun {
public:
    CellRun(const Technique& technique, const Condition& condition) {
        cell_.technique = &technique;
        cell_.condition = &condition;
    }

    void add(const StressCase& tried, RandomNumbers& random) {
        const Technique& technique = *cell_.technique;
        const ResolvedParameters parameters = resolve(tried.values, technique);
        if (parameters.is_published())
            add_queries(tried, parameters, random);
        else
            add_fragments(tried, parameters, random);
        cell_.non_monotone += falls(tried, technique) ? 1 : 0;
        ++cell_.rays;
    }

    StressCell finish() {
        const auto mean = [](const std::vector<double>& values) {
            return values.empty() ? 0
                                  : std::accumulate(values.begin(), values.end(), 0.0) /
                                        static_cast<double>(values.size());
        };
        std::ranges::sort(errors_);
        cell_.mean = mean(errors_);
        cell_.mean_from_truth = mean(from_truth_);
        if (!errors_.empty()) cell_.percentile_99 = errors_[(errors_.size() - 1) * 99 / 100];
        if (!errors_.empty()) cell_.worst = errors_.back();
        return cell_;
    }

private:
    // Techniques as published: at the depths of fragments and at random depths, by the bounds of beta.
    void add_queries(const StressCase& tried, const ResolvedParameters& parameters, RandomNumbers& random) {
        const Technique& technique = *cell_.technique;
        const ReconstructionSettings settings = settings_of(parameters);
        const MomentKernel& kernel = technique.moment_kernel();
        const MomentVector stored = sum_moments(tried.ray, technique, parameters);
        const MomentVector reordered = sum_moments(shuffled(tried.ray, random), technique, parameters);
        const auto exact = exact_function(tried.ray, technique, parameters);
        const double b0 = total_absorbance(tried.ray);
        std::vector<float> depths = some_own_depths(tried.ray);
        const std::size_t own_count = depths.size();
        for (int i = 0; i < RANDOM_DEPTHS; ++i) depths.push_back(random.uniform(-1, 1));
        const std::vector<double> truth = true_absorbance(tried.ray, depths);
        const std::vector<double> exactly = exact_absorbance(exact, tried.ray, parameters.beta, depths);
        const std::vector<float> fractions = fractions_at(depths, stored, kernel, settings);
        const std::vector<float> of_reordered = fractions_at(depths, reordered, kernel, settings);
        const std::vector<float> lower =
            fractions_at(depths, stored, kernel, with_overestimation(settings, 0));
        const std::vector<float> upper =
            fractions_at(depths, stored, kernel, with_overestimation(settings, 1));
        bool depends = false;
        for (std::size_t i = 0; i < depths.size(); ++i) {
            const double t = transmittance_of_fraction(fractions[i], stored.b0);
            count_outcome(fractions[i], t, std::exp(-exactly[i]), tried);
            count_bounds(lower[i], upper[i], truth[i] / b0);
            if (i < own_count) from_truth_.push_back(std::abs(t - std::exp(-truth[i])));
            depends |= std::abs(t - transmittance_of_fraction(of_reordered[i], reordered.b0)) > VISIBLE;
        }
        cell_.order_dependent += depends ? 1 : 0;
        if (settings.solver == Solver::robust)
            cell_.floored += kernel.steps(stored, settings, 0).floored_pivots > 0 ? 1 : 0;
    }

    // Techniques that know more of a fragment than its depth.
    void add_fragments(const StressCase& tried, const ResolvedParameters& parameters, RandomNumbers& random) {
        const Technique& technique = *cell_.technique;
        const MomentVector stored = sum_moments(tried.ray, technique, parameters);
        const MomentVector reordered = sum_moments(shuffled(tried.ray, random), technique, parameters);
        const std::vector<std::size_t> places = some_fragments(tried.ray);
        const auto estimates = fragment_estimates(tried.ray, stored, technique, parameters, places);
        const auto others = fragment_estimates(tried.ray, reordered, technique, parameters, places);
        const auto exact =
            exact_estimates(exact_function(tried.ray, technique, parameters), tried.ray, parameters, places);
        const std::vector<double> truth = true_absorbance(tried.ray, some_own_depths(tried.ray));
        const auto b0 = static_cast<double>(stored.b0);
        bool depends = false;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const auto t = static_cast<double>(estimates[i].transmittance);
            count_outcome(static_cast<float>(-std::log(t) / b0), t, exact[i].transmittance, tried);
            count_bounds(estimates[i].lower / stored.b0, estimates[i].upper / stored.b0, truth[i] / b0);
            from_truth_.push_back(std::abs(t - std::exp(-truth[i])));
            depends |= std::abs(t - static_cast<double>(others[i].transmittance)) > VISIBLE;
        }
        cell_.order_dependent += depends ? 1 : 0;
        cell_.floored +=
            technique.moment_kernel().steps(stored, settings_of(parameters), 0).floored_pivots > 0 ? 1 : 0;
    }

    // Counts the outcome of a query. Each query counts once, for the worst thing that happened.
    void count_outcome(float fraction, double t, double t_exact, const StressCase& tried) {
        ++cell_.queries;
        const double error = std::abs(t - t_exact);
        errors_.push_back(error);
        const Outcome outcome = classify(fraction, t, t_exact);
        cell_.not_numbers += outcome == Outcome::no_number ? 1 : 0;
        cell_.outside += outcome == Outcome::outside ? 1 : 0;
        cell_.inaccurate += outcome == Outcome::inaccurate ? 1 : 0;
        const bool in_tolerance = outcome == Outcome::inaccurate || outcome == Outcome::ok;
        cell_.clamped += in_tolerance && (fraction < 0 || fraction > 1) ? 1 : 0;
        const double badness = outcome == Outcome::no_number ? 2.0 : error;
        if (badness <= worst_) return;
        worst_ = badness;
        cell_.worst_case = tried;
    }

    void count_bounds(float lower, float upper, double true_fraction) {
        constexpr double TOLERANCE = 1e-3;
        const bool inside = true_fraction >= static_cast<double>(lower) - TOLERANCE &&
                            true_fraction <= static_cast<double>(upper) + TOLERANCE;
        cell_.truth_outside += inside ? 0 : 1;
    }

    static bool falls(const StressCase& tried, const Technique& technique) {
        static const std::vector<float> DEPTHS = even_depths(CURVE_SAMPLES);
        const Curve curve = sample_curve(tried.ray, technique, tried.values, DEPTHS);
        float most = 0;
        bool result = false;
        for (const float absorbance : curve.reconstructed) {
            result |= absorbance < most - 1e-3f * curve.moments.b0;
            most = std::max(most, absorbance);
        }
        return result;
    }

    StressCell cell_;
    std::vector<double> errors_, from_truth_;
    double worst_ = -1;
};

std::uint32_t seed_of(const Condition& condition, std::uint32_t seed) {
    // All techniques get the same rays. The hash is FNV-1a, because std::hash may differ between libraries.
    std::uint32_t hash = 2166136261U ^ seed;
    for (const char letter : condition.id) hash = (hash ^ static_cast<unsigned char>(letter)) * 16777619U;
    return hash;
}

}  // namespace

StressCell stress_cell(const Technique& technique, const Condition& condition, const StressOptions& options,
                       const std::stop_token& stop) {
    CellRun run(technique, condition);
    RandomNumbers random(seed_of(condition, options.seed));
    const int affordable = std::max(options.rays * 100 / std::max(condition.fragments, 100), 4);
    for (int i = std::min(affordable, options.rays); i > 0 && !stop.stop_requested(); --i)
        run.add(condition.make(random, technique, options.values), random);
    return run.finish();
}

Sliced<std::vector<StressCell>> stress_in_parts(StressOptions options, std::stop_token stop,
                                                StressProgress progress) {
    const std::size_t columns = options.conditions.size();
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < options.techniques.size() * columns; ++i)
        if (options.shard.holds(i)) places.push_back(i);
    std::vector<StressCell> cells(places.size());
    std::atomic<std::size_t> done = 0;
    co_await Parts(
        cells.size(),
        [&](std::size_t i) {
            cells[i] = stress_cell(*options.techniques[places[i] / columns],
                                   *options.conditions[places[i] % columns], options, stop);
            progress(++done, cells.size());
        },
        stop);
    if (stop.stop_requested()) cells.clear();
    co_return cells;
}

std::vector<StressCell> run_stress(const StressOptions& options, std::stop_token stop,
                                   const StressProgress& progress) {
    return stress_in_parts(options, std::move(stop), progress).finish();
}

}  // namespace momentscope
