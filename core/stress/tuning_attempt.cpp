#include "core/stress/tuning_attempt.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/inspect/exact_estimates.hpp"
#include "core/inspect/fragment_estimates.hpp"
#include "core/stress/classify.hpp"
#include "core/techniques/moment_kernel.hpp"

namespace momentscope {

namespace {

constexpr std::size_t RAYS = 32;  // that a thread takes at a time

// T at `depths` from exact arithmetic on stored moments; empty if rounding made the matrix singular.
std::vector<double> exact_of_stored(const MomentVector& stored, const Technique& technique,
                                    const ResolvedParameters& parameters, const std::vector<float>& depths) {
    std::vector<double> t;
    const auto exact = exact_function_of_stored(stored, technique, parameters);
    for (std::size_t i = 0; exact && i < depths.size(); ++i) {
        const Real share = (*exact)(static_cast<Real>(depths[i])).with(parameters.beta);
        t.push_back(transmittance_of_fraction(static_cast<float>(share), stored.b0));
    }
    return t;
}

// The queries at the depths of one ray: their place among those of many rays.
struct RayQueries {
    const ViewRay* ray;
    std::size_t first, count;
};

// Adds the errors of one ray with these stored moments and fractions. If `judged`, also counts failures.
void add_ray(const ViewRay& ray, const MomentVector& stored, std::span<const float> fractions,
             const Technique& technique, const ResolvedParameters& parameters, bool judged,
             TuningAttempt::Sums& sums) {
    const std::vector<float> depths = some_own_depths(ray);
    const std::vector<double> truth = true_absorbance(ray, depths);
    std::vector<double> exact;
    std::vector<double> of_stored;
    if (judged) {
        exact = exact_absorbance(exact_function(ray, technique, parameters), ray, parameters.beta, depths);
        of_stored = exact_of_stored(stored, technique, parameters, depths);
    }
    for (std::size_t i = 0; i < depths.size(); ++i) {
        const double t = transmittance_of_fraction(fractions[i], stored.b0);
        const double error = t - std::exp(-truth[i]);
        sums.squares += error * error;
        ++sums.queries;
        if (!judged) continue;
        const double exact_t = std::exp(-exact[i]);
        sums.failures += classify(fractions[i], t, exact_t) == Outcome::ok ? 0 : 1;
        sums.inherent += of_stored.empty() || std::abs(of_stored[i] - exact_t) > FAILED_ERROR ? 1 : 0;
    }
}

// The same for techniques that know more of a fragment than its depth.
void add_fragments(const ViewRay& ray, const Technique& technique, const ResolvedParameters& parameters,
                   bool judged, TuningAttempt::Sums& sums) {
    const MomentVector stored = sum_moments(ray, technique, parameters);
    const std::vector<std::size_t> places = some_fragments(ray);
    const auto estimates = fragment_estimates(ray, stored, technique, parameters, places);
    const std::vector<double> truth = true_absorbance(ray, some_own_depths(ray));
    std::vector<ExactEstimate> exact, of_stored;
    if (judged) {
        exact = exact_estimates(exact_function(ray, technique, parameters), ray, parameters, places);
        const auto function = exact_function_of_stored(stored, technique, parameters);
        if (function) of_stored = exact_estimates(function, ray, parameters, places);
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto t = static_cast<double>(estimates[i].transmittance);
        const double error = t - std::exp(-truth[i]);
        sums.squares += error * error;
        ++sums.queries;
        if (!judged) continue;
        const double exact_t = exact[i].transmittance;
        sums.failures += !(std::abs(t - exact_t) <= FAILED_ERROR) ? 1 : 0;
        sums.inherent +=
            of_stored.empty() || std::abs(of_stored[i].transmittance - exact_t) > FAILED_ERROR ? 1 : 0;
    }
}

// Adds the errors of several rays. All their queries run at once.
void add_rays(std::span<const ViewRay> rays, const Technique& technique, const ResolvedParameters& parameters,
              bool judged, TuningAttempt::Sums& sums) {
    if (!parameters.is_published()) {
        for (const ViewRay& ray : rays) add_fragments(ray, technique, parameters, judged, sums);
        return;
    }
    std::vector<RayQueries> queries;
    std::vector<MomentVector> stored;
    std::vector<float> depths;
    for (const ViewRay& ray : rays) {
        const std::vector<float> own = some_own_depths(ray);
        if (own.empty()) continue;
        queries.push_back({&ray, depths.size(), own.size()});
        stored.insert(stored.end(), own.size(), sum_moments(ray, technique, parameters));
        depths.insert(depths.end(), own.begin(), own.end());
    }
    std::vector<float> fractions(depths.size());
    technique.moment_kernel().fractions(stored, settings_of(parameters), depths, fractions);
    for (const RayQueries& of_ray : queries)
        add_ray(*of_ray.ray, stored[of_ray.first], std::span(fractions).subspan(of_ray.first, of_ray.count),
                technique, parameters, judged, sums);
}

}  // namespace

TuningAttempt::TuningAttempt(const std::vector<ViewRay>& rays, const Technique& technique,
                             const ParameterValues& values, bool judged)
    : rays_(rays),
      technique_(technique),
      parameters_(resolve(values, technique)),
      judged_(judged),
      sums_((rays.size() + RAYS - 1) / RAYS) {}

Parts TuningAttempt::parts(const std::stop_token& stop) {
    const auto add = [this](std::size_t i) {
        add_rays(std::span(rays_).subspan(i * RAYS, std::min(RAYS, rays_.size() - i * RAYS)), technique_,
                 parameters_, judged_, sums_[i]);
    };
    return {sums_.size(), add, stop};
}

Trial TuningAttempt::trial(ParameterId id, float value) const {
    Sums all;
    for (const Sums& part : sums_) {
        all.squares += part.squares;
        all.queries += part.queries;
        all.failures += part.failures;
        all.inherent += part.inherent;
    }
    const auto queries = static_cast<double>(std::max(all.queries, 1L));
    return {id, value, std::sqrt(all.squares / queries), static_cast<double>(all.failures) / queries,
            static_cast<double>(all.inherent) / queries};
}

}  // namespace momentscope
