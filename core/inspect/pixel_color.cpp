#include "core/inspect/pixel_color.hpp"

#include <cmath>

#include "core/inspect/drawn_fragments.hpp"
#include "core/inspect/pixel_state_curve.hpp"

#include "core/support/glsl.hpp"

namespace momentscope {

namespace glsl {
namespace {
#include "shaders/shared/renormalization.glsl"
}  // namespace
}  // namespace glsl

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

glm::vec3 composited_color(glm::vec4 weighted, const glm::vec4& uncertain, float absorbance,
                           const ResolvedParameters& parameters, const glm::vec3& background) {
    const float behind = std::exp(-absorbance);
    if (parameters.moves_uncertain())
        weighted += glsl::moved_share(weighted.a, uncertain.a, 1 - behind) * uncertain;
    const float scale = parameters.renormalizes() && weighted.a > 0 ? (1 - behind) / weighted.a : 1;
    return glm::vec3(weighted) * scale + behind * background;
}

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
    glm::vec4 weighted(0), uncertain(0);
    for (const PixelHistoryRow& row : rows) {
        absorbance += row.absorbance;
        weighted += row.source;
        uncertain += row.uncertain;
    }
    if (technique.has_pixel_states()) {
        colors.technique = pixel_state_color(ray, technique, parameters, background);
        return colors;
    }
    colors.technique = composited_color(weighted, uncertain, absorbance, parameters, background);
    return colors;
}

}  // namespace momentscope
