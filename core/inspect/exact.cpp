#include "core/inspect/exact.hpp"

#include "core/inspect/exact.inl"

namespace momentscope {

std::optional<ExactFunction> exact_function(const ViewRay& ray, const Technique& technique,
                                            const ResolvedParameters& parameters) {
    return any_precision::exact_function<Real>(ray, technique, parameters);
}

std::optional<ExactFunction> exact_function_of_stored(const MomentVector& stored, const Technique& technique,
                                                      const ResolvedParameters& parameters) {
    return any_precision::exact_function_of_stored<Real>(stored, technique, parameters);
}

std::vector<double> exact_absorbance(const std::optional<ExactFunction>& exact, const ViewRay& ray,
                                     float beta, std::span<const float> depths) {
    const auto masses = any_precision::exact_masses<Real>(ray);
    const auto here = static_cast<Real>(beta);
    Real total = 0;
    for (const auto& mass : masses) total += mass.absorbance;
    std::vector<double> absorbance;
    absorbance.reserve(depths.size());
    for (const float depth : depths) {
        const auto at = static_cast<Real>(depth);
        if (exact) {
            const Real share = (*exact)(at).with(beta);
            absorbance.push_back(static_cast<double>(total * std::clamp(share, Real(0), Real(1))));
        } else {
            Real sum = 0;
            for (const auto& mass : masses)
                if (mass.depth <= at) sum += mass.absorbance * (mass.depth < at ? 1 : here);
            absorbance.push_back(static_cast<double>(sum));
        }
    }
    return absorbance;
}

}  // namespace momentscope
