#include "core/inspect/pixel_color.hpp"

#include <cmath>

#include "core/inspect/drawn_fragments.hpp"
#include "core/inspect/pixel_state_curve.hpp"

namespace momentscope {

namespace {

// Front to back, so that fragments at the same depth are composited one after the other.
glm::vec3 sorted_color(const ViewRay& ray, const glm::vec3& background) {
    glm::vec3 color(0);
    float transmittance = 1;
    for (const std::size_t i : front_to_back(ray)) {
        const Fragment& fragment = ray.fragments[i];
        color += transmittance * fragment.opacity * fragment.color;
        transmittance *= 1 - fragment.opacity;
    }
    return color + transmittance * background;
}

}  // namespace

PixelColors pixel_colors(const ViewRay& ray, const std::vector<PixelHistoryRow>& rows,
                         const Technique& technique, const ResolvedParameters& parameters,
                         const glm::vec3& background) {
    PixelColors colors;
    colors.truth = sorted_color(ray, background);
    if (technique.is_truth()) {
        colors.technique = sorted_color(drawn_fragments(ray, technique), background);
        return colors;
    }
    float absorbance = 0;
    glm::vec4 weighted(0);
    for (const PixelHistoryRow& row : rows) {
        absorbance += row.absorbance;
        weighted += row.source;
    }
    if (technique.has_pixel_states()) {
        colors.technique = pixel_state_color(ray, technique, parameters, background);
        return colors;
    }
    const float behind = std::exp(-absorbance);
    const float scale = parameters.renormalize && weighted.a > 0 ? (1 - behind) / weighted.a : 1;
    colors.technique = glm::vec3(weighted) * scale + behind * background;
    return colors;
}

}  // namespace momentscope
