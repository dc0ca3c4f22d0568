#include "core/inspect/fragment_estimates.hpp"

namespace momentscope {

std::vector<FragmentEstimate> fragment_estimates(const ViewRay& ray, const Technique& technique,
                                                 const ResolvedParameters& parameters) {
    std::vector<float> own;
    for (const Fragment& fragment : ray.fragments) own.push_back(fragment_absorbance(fragment.opacity));
    std::vector<FragmentEstimate> estimates(own.size());
    technique.moment_kernel().estimates(sum_moments(ray, technique, parameters), settings_of(parameters),
                                        own_depths(ray), own, estimates);
    return estimates;
}

}  // namespace momentscope
