#include "core/inspect/pixel_history.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "core/inspect/drawn_fragments.hpp"
#include "core/inspect/fragment_estimates.hpp"
#include "core/inspect/pixel_state_curve.hpp"

namespace momentscope {

std::vector<PixelHistoryRow> pixel_history(const ViewRay& ray, std::span<const float> gl_transmittance,
                                           const Technique& technique, const ParameterValues& values) {
    std::vector<float> depths;
    for (const Fragment& fragment : ray.fragments) depths.push_back(fragment.depth);
    const Curve curve = sample_curve(ray, technique, values, depths);
    const std::vector<float> own = technique.has_pixel_states()
                                       ? own_transmittance(ray, technique, curve.parameters.settings)
                                       : std::vector<float>();
    const std::vector<bool> drawn = drawn_flags(ray, technique);
    const std::vector<FragmentEstimate> estimates = technique.has_moments()
                                                        ? fragment_estimates(ray, technique, curve.parameters)
                                                        : std::vector<FragmentEstimate>();
    std::vector<PixelHistoryRow> in_submission_order;
    glm::vec4 sum(0);
    for (std::size_t i = 0; i < ray.fragments.size(); ++i) {
        const Fragment& fragment = ray.fragments[i];
        PixelHistoryRow row{};
        row.fragment = i;
        row.absorbance = fragment_absorbance(fragment.opacity);
        row.true_transmittance = std::exp(-curve.truth[i]);
        row.transmittance = own.empty() ? transmittance(curve.reconstructed[i]) : own[i];
        if (!estimates.empty()) {
            row.estimate = estimates[i];
            row.transmittance = estimates[i].transmittance;
            row.uncertain = estimates[i].spread * fragment.opacity * glm::vec4(fragment.color, 1);
        }
        if (!gl_transmittance.empty()) row.gl_transmittance = gl_transmittance[i];
        if (drawn[i]) row.source = row.transmittance * fragment.opacity * glm::vec4(fragment.color, 1);
        row.sum = sum;
        sum += row.source;
        in_submission_order.push_back(row);
    }
    std::vector<PixelHistoryRow> rows;
    for (const std::size_t i : front_to_back(ray)) rows.push_back(in_submission_order[i]);
    return rows;
}

std::string pixel_history_to_csv(const ViewRay& ray, const std::vector<PixelHistoryRow>& rows) {
    std::string text =
        "draw,primitive,view_depth,depth,opacity,absorbance,true_transmittance,gl_transmittance,"
        "transmittance,"
        "error,source_r,source_g,source_b,source_weight,sum_r,sum_g,sum_b,sum_weight\n";
    for (const PixelHistoryRow& row : rows) {
        const Fragment& f = ray.fragments[row.fragment];
        const std::string gl = row.gl_transmittance ? fmt::format("{}", *row.gl_transmittance) : "";
        fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                       f.draw, f.primitive, f.view_depth, f.depth, f.opacity, row.absorbance,
                       row.true_transmittance, gl, row.transmittance, row.error(), row.source.r, row.source.g,
                       row.source.b, row.source.a, row.sum.r, row.sum.g, row.sum.b, row.sum.a);
    }
    return text;
}

}  // namespace momentscope
