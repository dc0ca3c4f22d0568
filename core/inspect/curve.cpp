#include "core/inspect/curve.hpp"

#include <algorithm>
#include <cmath>

#include "core/inspect/drawn_fragments.hpp"
#include "core/inspect/pixel_state_curve.hpp"

namespace momentscope {

std::vector<float> even_depths(std::size_t samples) {
    std::vector<float> depths(samples);
    for (std::size_t i = 0; i < samples; ++i)
        depths[i] = 2.0f * static_cast<float>(i) / static_cast<float>(samples - 1) - 1.0f;
    return depths;
}

double shown_absorbance(double t, double total) {
    const auto opaque = static_cast<double>(fragment_absorbance(1.0f));
    return t > 0 ? 0 - std::log(t) : std::max(opaque, total);  // for T = 1 this is 0, not -0
}

MomentVector sum_moments(const ViewRay& ray, const Technique& technique,
                         const ResolvedParameters& parameters) {
    const MomentKernel& kernel = technique.moment_kernel();
    const ReconstructionSettings settings = settings_of(parameters);
    MomentVector sum;
    if (parameters.knows_ends())
        for (const Fragment& fragment : ray.fragments)
            kernel.add_ends(sum, fragment.depth, fragment_absorbance(fragment.opacity));
    for (const Fragment& fragment : ray.fragments)
        kernel.add_fragment(sum, fragment.depth, fragment_absorbance(fragment.opacity), settings);
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
    if (technique.has_pixel_states()) {
        if (!technique.pixel_state_kernel().has_depths() || why_refused(technique, values) != nullptr)
            return curve;
        // This pixel was captured from a scene with a technique without low resolution, so the fragments of
        // its neighbours are missing.
        if (resolution_divisor(technique, curve.parameters.settings) > 1 &&
            ray.low_resolution_sources.empty() && ray.far_plane > 0)
            return curve;
        for (const float t : pixel_state_transmittance(ray, technique, curve.parameters.settings, depths))
            curve.reconstructed.push_back(
                static_cast<float>(shown_absorbance(static_cast<double>(t), curve.total_absorbance)));
        return curve;
    }
    if (!technique.has_moments()) {  // a ground truth reconstructs the fragments that it draws
        const std::vector<double> drawn = true_absorbance(drawn_fragments(ray, technique), depths);
        curve.reconstructed.assign(drawn.begin(), drawn.end());
        return curve;
    }
    curve.moments = sum_moments(ray, technique, curve.parameters);
    curve.reconstructed.resize(depths.size());
    curve.beta0.resize(depths.size());
    curve.beta1.resize(depths.size());
    technique.moment_kernel().evaluate(curve.moments, settings_of(curve.parameters), depths,
                                       {curve.reconstructed, curve.beta0, curve.beta1});
    return curve;
}

}  // namespace momentscope
