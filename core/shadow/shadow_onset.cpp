#include "core/shadow/shadow_onset.hpp"

#include <algorithm>
#include <cmath>

#include "core/inspect/curve.hpp"

namespace momentscope {

ShadowOnset shadow_onset(const ViewRay& ray, std::uint32_t draw, const Configuration& configuration) {
    constexpr std::size_t SAMPLES = 4001;
    ViewRay without = ray;
    std::erase_if(without.fragments, [&](const Fragment& fragment) { return fragment.draw == draw; });
    const std::vector<float> depths = even_depths(SAMPLES);
    const Curve all = sample_curve(ray, *configuration.technique, configuration.values, depths);
    const Curve others = sample_curve(without, *configuration.technique, configuration.values, depths);
    std::vector<double> shadow;
    for (std::size_t i = 0; i < SAMPLES; ++i)
        shadow.push_back(1 - std::exp(static_cast<double>(others.reconstructed[i] - all.reconstructed[i])));
    const double last = shadow.back();
    std::size_t low = 0, high = SAMPLES - 1;
    while (low + 1 < SAMPLES && shadow[low] <= 0.1 * last) ++low;
    while (high > 0 && shadow[high - 1] >= 0.9 * last) --high;
    ShadowOnset onset;
    double weight = 0, sum = 0;
    for (const Fragment& fragment : ray.fragments) {
        if (fragment.draw != draw) continue;
        const auto absorbance = static_cast<double>(fragment_absorbance(fragment.opacity));
        sum += absorbance * static_cast<double>(fragment.view_depth);
        weight += absorbance;
    }
    if (weight > 0) onset.caster = static_cast<float>(sum / weight);
    onset.low = to_view_depth(depths[low], ray.warp);
    onset.high = to_view_depth(depths[high], ray.warp);
    return onset;
}

}  // namespace momentscope
