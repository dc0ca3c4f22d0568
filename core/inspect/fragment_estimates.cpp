#include "core/inspect/fragment_estimates.hpp"

#include <numeric>

namespace momentscope {

std::vector<FragmentEstimate> fragment_estimates(const ViewRay& ray, const MomentVector& stored,
                                                 const Technique& technique,
                                                 const ResolvedParameters& parameters,
                                                 std::span<const std::size_t> places) {
    std::vector<float> depths, own;
    for (const std::size_t place : places) {
        depths.push_back(ray.fragments[place].depth);
        own.push_back(fragment_absorbance(ray.fragments[place].opacity));
    }
    std::vector<FragmentEstimate> estimates(places.size());
    technique.moment_kernel().estimates(stored, settings_of(parameters), depths, own, estimates);
    return estimates;
}

std::vector<FragmentEstimate> fragment_estimates(const ViewRay& ray, const Technique& technique,
                                                 const ResolvedParameters& parameters) {
    std::vector<std::size_t> all(ray.fragments.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return fragment_estimates(ray, sum_moments(ray, technique, parameters), technique, parameters, all);
}

}  // namespace momentscope
