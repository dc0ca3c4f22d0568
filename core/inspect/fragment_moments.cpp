#include "core/inspect/fragment_moments.hpp"

#include <fmt/format.h>

namespace momentscope {

std::vector<MomentVector> fragment_moments(const ViewRay& ray, const Curve& curve) {
    std::vector<MomentVector> rows;
    if (!curve.technique->has_moments()) return rows;
    const MomentKernel& kernel = curve.technique->moment_kernel();
    const ReconstructionSettings settings = settings_of(curve.parameters);
    for (const Fragment& fragment : ray.fragments) {
        MomentVector alone;
        alone.near_step = curve.moments.near_step;  // the interval of the moments is that of the whole ray
        alone.far_step = curve.moments.far_step;
        kernel.add_fragment(alone, fragment.depth, fragment_absorbance(fragment.opacity), settings);
        rows.push_back(kernel.moments_of(alone));
    }
    return rows;
}

MomentVector ray_moments(const Curve& curve) {
    return curve.technique->moment_kernel().moments_of(curve.moments);
}

std::vector<std::string> moment_names(const Technique& technique) {
    constexpr const char* POWERS[] = {"z", "z²", "z³", "z⁴", "z⁵", "z⁶", "z⁷", "z⁸"};
    std::vector<std::string> names;
    const int count = technique.moment_kernel().moment_floats;
    for (int i = 0; i < count; ++i) {
        if (technique.on_circle())
            names.push_back(
                fmt::format("{} {}φ", i % 2 == 0 ? "cos" : "sin", i < 2 ? "" : std::to_string(i / 2 + 1)));
        else if (technique.is_of(BasisFamily::chebyshev))
            names.push_back(fmt::format("T{}", i + 1));
        else
            names.emplace_back(POWERS[i]);
    }
    return names;
}

}  // namespace momentscope
