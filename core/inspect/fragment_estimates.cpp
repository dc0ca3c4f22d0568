#include "core/inspect/fragment_estimates.hpp"

#include <cmath>

namespace momentscope {

namespace {

constexpr glm::vec3 LUMINANCE = {0.2126f, 0.7152f, 0.0722f};  // of linear sRGB (Rec. 709)

}  // namespace

std::vector<FragmentEstimate> fragment_estimates(const ViewRay& ray, const Technique& technique,
                                                 const ResolvedParameters& parameters) {
    std::vector<float> own;
    for (const Fragment& fragment : ray.fragments) own.push_back(fragment_absorbance(fragment.opacity));
    std::vector<FragmentEstimate> estimates(own.size());
    technique.moment_kernel().estimates(sum_moments(ray, technique, parameters), settings_of(parameters),
                                        own_depths(ray), own, estimates);
    return estimates;
}

double color_uncertainty(const ViewRay& ray, const std::vector<FragmentEstimate>& estimates) {
    double sum = 0;
    for (std::size_t i = 0; i < estimates.size(); ++i) {
        const Fragment& fragment = ray.fragments[i];
        const double wider = std::exp(-static_cast<double>(estimates[i].lower)) -
                             std::exp(-static_cast<double>(estimates[i].upper));
        sum += static_cast<double>(fragment.opacity * std::abs(glm::dot(LUMINANCE, fragment.color))) * wider;
    }
    return sum;
}

}  // namespace momentscope
