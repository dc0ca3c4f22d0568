#include "core/inspect/pixel_color.hpp"

#include <cmath>

#include "core/inspect/method_pixel.hpp"

namespace momentscope {

PixelColors pixel_colors(const ViewRay& ray, const std::vector<PixelHistoryRow>& rows,
                         const Technique& technique, const ResolvedParameters& parameters,
                         const glm::vec3& background) {
    PixelColors colors;
    float transmittance = 1;
    float absorbance = 0;
    glm::vec4 weighted(0);
    for (const PixelHistoryRow& row :
         rows) {  // front to back, so that ties are composited one after the other
        const Fragment& fragment = ray.fragments[row.fragment];
        colors.truth += transmittance * fragment.opacity * fragment.color;
        transmittance *= 1 - fragment.opacity;
        absorbance += row.absorbance;
        weighted += row.source;
    }
    colors.truth += transmittance * background;
    if (technique.method != nullptr) {
        colors.technique = method_color(ray, technique, parameters, background);
        return colors;
    }
    const float behind = std::exp(-absorbance);
    const float scale = parameters.renormalize && weighted.a > 0 ? (1 - behind) / weighted.a : 1;
    colors.technique = glm::vec3(weighted) * scale + behind * background;
    return colors;
}

}  // namespace momentscope
