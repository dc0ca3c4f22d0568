#include "core/stress/stress.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <thread>

#include "core/inspect/exact.hpp"
#include "core/techniques/moment_kernel.hpp"

namespace momentscope {

namespace {

constexpr std::size_t CURVE_SAMPLES = 65;
constexpr int RANDOM_DEPTHS = 2;
constexpr std::size_t MOST_OWN_DEPTHS = 8;
constexpr double VISIBLE = 1.0 / 255;

// The exact result at the same alpha. Where the matrix is singular, moments leave one distribution alone: the
// truth, with beta of a mass at the query depth itself.
double exact_absorbance(const std::optional<ExactFunction>& exact, const ViewRay& ray, double b0, float beta,
                        float depth) {
    if (exact) {
        const ExactFraction fraction = (*exact)(static_cast<Real>(depth));
        const Real share = fraction.in_front + static_cast<Real>(beta) * fraction.query_weight;
        return b0 * static_cast<double>(std::clamp(share, Real(0), Real(1)));
    }
    double absorbance = 0;
    for (const Fragment& fragment : ray.fragments)
        if (fragment.depth <= depth)
            absorbance += static_cast<double>(fragment_absorbance(fragment.opacity)) *
                          (fragment.depth < depth ? 1.0 : static_cast<double>(beta));
    return absorbance;
}

// Few of many fragments, evenly chosen.
std::vector<float> query_depths(const ViewRay& ray, RandomNumbers& random, std::size_t& own_count) {
    std::vector<float> depths;
    const std::size_t count = ray.fragments.size();
    const std::size_t step = std::max<std::size_t>(count / MOST_OWN_DEPTHS, 1);
    for (std::size_t i = 0; i < count && depths.size() < MOST_OWN_DEPTHS; i += step)
        depths.push_back(ray.fragments[i].depth);
    own_count = depths.size();
    for (int i = 0; i < RANDOM_DEPTHS; ++i) depths.push_back(random.uniform(-1, 1));
    return depths;
}

ViewRay shuffled(const ViewRay& ray, RandomNumbers& random) {
    ViewRay result = ray;
    for (std::size_t i = result.fragments.size(); i > 1; --i)
        std::swap(result.fragments[i - 1],
                  result.fragments[static_cast<std::size_t>(random.whole(0, static_cast<int>(i) - 1))]);
    return result;
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
        const ReconstructionSettings settings = settings_of(parameters);
        const MomentKernel& kernel = *technique.kernel;
        const MomentVector stored = sum_moments(tried.ray, technique, parameters);
        const MomentVector reordered = sum_moments(shuffled(tried.ray, random), technique, parameters);
        const auto exact = exact_function(tried.ray, technique, parameters);
        const double b0 = total_absorbance(tried.ray);
        std::size_t own_count = 0;
        const std::vector<float> depths = query_depths(tried.ray, random, own_count);
        const std::vector<double> truth = true_absorbance(tried.ray, depths);
        bool depends = false;
        for (std::size_t i = 0; i < depths.size(); ++i) {
            const float fraction = kernel.fraction(stored, settings, depths[i]);
            const double t = transmittance_of_fraction(fraction, stored.b0);
            const double t_exact =
                std::exp(-exact_absorbance(exact, tried.ray, b0, parameters.beta, depths[i]));
            count_outcome(fraction, t, t_exact, tried);
            count_bounds(kernel, stored, settings, depths[i], truth[i] / b0);
            if (i < own_count) from_truth_.push_back(std::abs(t - std::exp(-truth[i])));
            const double t_reordered =
                transmittance_of_fraction(kernel.fraction(reordered, settings, depths[i]), reordered.b0);
            depends |= std::abs(t - t_reordered) > VISIBLE;
        }
        cell_.order_dependent += depends ? 1 : 0;
        cell_.non_monotone += falls(tried, technique) ? 1 : 0;
        if (settings.solver == Solver::robust)
            cell_.floored += kernel.steps(stored, settings, 0).floored_pivots > 0 ? 1 : 0;
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
    static double transmittance_of_fraction(float fraction, float b0) {
        const double clamped =
            fraction >= 0 ? std::min(static_cast<double>(fraction), 1.0) : 0.0;  // NaN is 0, as on GPUs
        return std::exp(-static_cast<double>(b0) * clamped);
    }

    // Each query counts once, for the gravest thing that happened.
    void count_outcome(float fraction, double t, double t_exact, const StressCase& tried) {
        ++cell_.queries;
        const double error = std::abs(t - t_exact);
        errors_.push_back(error);
        const bool number = std::isfinite(fraction);
        const bool within = fraction >= -CLAMP_TOLERANCE && fraction <= 1 + CLAMP_TOLERANCE;
        if (!number)
            ++cell_.not_numbers;
        else if (!within)
            ++cell_.outside;
        else if (error > FAILED_ERROR)
            ++cell_.off;
        if (number && within && (fraction < 0 || fraction > 1)) ++cell_.clamped;
        const double badness = number ? error : 2.0;
        if (badness <= worst_) return;
        worst_ = badness;
        cell_.worst_case = tried;
    }

    void count_bounds(const MomentKernel& kernel, const MomentVector& stored, ReconstructionSettings settings,
                      float depth, double true_fraction) {
        constexpr double TOLERANCE = 1e-3;
        settings.overestimation = 0;
        const auto lower = static_cast<double>(kernel.fraction(stored, settings, depth));
        settings.overestimation = 1;
        const auto upper = static_cast<double>(kernel.fraction(stored, settings, depth));
        const bool inside = true_fraction >= lower - TOLERANCE && true_fraction <= upper + TOLERANCE;
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
    // All techniques see the same rays. FNV-1a, because std::hash may differ from one library to another.
    std::uint32_t hash = 2166136261U ^ seed;
    for (const char letter : condition.id) hash = (hash ^ static_cast<unsigned char>(letter)) * 16777619U;
    return hash;
}

}  // namespace

StressCell stress_cell(const Technique& technique, const Condition& condition, const StressOptions& options) {
    CellRun run(technique, condition);
    RandomNumbers random(seed_of(condition, options.seed));
    const int rays = std::clamp(options.rays * 100 / std::max(condition.fragments, 100), 4, options.rays);
    for (int i = 0; i < rays; ++i) run.add(condition.make(random, technique, options.values), random);
    return run.finish();
}

std::vector<StressCell> run_stress(const StressOptions& options, std::stop_token stop,
                                   const std::function<void(std::size_t done, std::size_t all)>& progress) {
    const std::size_t columns = options.conditions.size();
    std::vector<StressCell> cells(options.techniques.size() * columns);
    std::atomic<std::size_t> next = 0;
    std::atomic<std::size_t> done = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < cells.size() && !stop.stop_requested(); i = next++) {
            cells[i] =
                stress_cell(*options.techniques[i / columns], *options.conditions[i % columns], options);
            progress(++done, cells.size());
        }
    };
    {
        std::vector<std::jthread> threads;
        for (unsigned i = 0; i < std::max(std::thread::hardware_concurrency(), 1U); ++i)
            threads.emplace_back(work);
    }
    if (stop.stop_requested()) cells.clear();
    return cells;
}

}  // namespace momentscope
