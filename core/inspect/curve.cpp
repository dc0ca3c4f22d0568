#include "core/inspect/curve.hpp"

#include <algorithm>
#include <cmath>

#include "core/inspect/method_pixel.hpp"

namespace momentscope {

std::vector<float> even_depths(std::size_t samples) {
    std::vector<float> depths(samples);
    for (std::size_t i = 0; i < samples; ++i)
        depths[i] = 2.0f * static_cast<float>(i) / static_cast<float>(samples - 1) - 1.0f;
    return depths;
}

MomentVector sum_moments(const ViewRay& ray, const Technique& technique,
                         const ResolvedParameters& parameters) {
    MomentVector sum;
    for (const Fragment& fragment : ray.fragments)
        technique.kernel->add_fragment(sum, fragment.depth, fragment_absorbance(fragment.opacity),
                                       parameters.theta);
    return sum;
}

Curve sample_curve(const ViewRay& ray, const Technique& technique, const ParameterValues& values,
                   std::span<const float> depths) {
    Curve curve;
    curve.technique = &technique;
    curve.values = values;
    curve.parameters = resolve(values, technique);
    curve.total_absorbance = total_absorbance(ray);
    curve.depth.assign(depths.begin(), depths.end());
    curve.truth = true_absorbance(ray, depths);
    if (technique.method != nullptr) {
        if (!technique.method->has_depths() || why_refused(technique, values) != nullptr) return curve;
        // A pixel of a scene without its neighbours' fragments: captured for a technique without low
        // resolution.
        if (curve.parameters.method.divisor > 1 && ray.shares.empty() && ray.far_plane > 0) return curve;
        constexpr float LEAST_T = 1e-30f;
        for (const float t : method_transmittance(ray, technique, curve.parameters.method, depths))
            curve.reconstructed.push_back(0.0f - std::log(std::max(t, LEAST_T)));
        return curve;
    }
    if (technique.kernel == nullptr) {  // the ground truth reconstructs itself
        curve.reconstructed.assign(curve.truth.begin(), curve.truth.end());
        return curve;
    }
    curve.moments = sum_moments(ray, technique, curve.parameters);
    curve.reconstructed.resize(depths.size());
    curve.beta0.resize(depths.size());
    curve.beta1.resize(depths.size());
    technique.kernel->evaluate(curve.moments, settings_of(curve.parameters), depths,
                               {curve.reconstructed, curve.beta0, curve.beta1});
    return curve;
}

}  // namespace momentscope
