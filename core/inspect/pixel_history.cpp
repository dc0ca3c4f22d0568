#include "core/inspect/pixel_history.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "core/inspect/drawn_fragments.hpp"
#include "core/inspect/fragment_estimates.hpp"
#include "core/inspect/pixel_state_curve.hpp"

namespace momentscope {

namespace {

// T of each fragment by a technique without moments; for a ground truth, of what it draws.
std::vector<float> other_transmittances(const ViewRay& ray, const Technique& technique,
                                        const ResolvedParameters& parameters) {
    if (technique.has_pixel_states()) return own_transmittance(ray, technique, parameters.settings);
    std::vector<float> t;
    for (const double absorbance : true_absorbance(drawn_fragments(ray, technique), own_depths(ray)))
        t.push_back(transmittance(static_cast<float>(absorbance)));
    return t;
}

}  // namespace

std::vector<PixelHistoryRow> pixel_history(const ViewRay& ray, std::span<const float> gl_transmittance,
                                           const Technique& technique, const ParameterValues& values) {
    const ResolvedParameters parameters = resolve(values, technique);
    const std::vector<double> truth = true_absorbance(ray, own_depths(ray));
    const std::vector<bool> drawn = drawn_flags(ray, technique);
    std::vector<FragmentEstimate> estimates;
    std::vector<float> t;
    if (technique.has_moments())
        estimates = fragment_estimates(ray, technique, parameters);
    else
        t = other_transmittances(ray, technique, parameters);
    std::vector<PixelHistoryRow> in_submission_order;
    glm::vec4 sum(0);
    for (std::size_t i = 0; i < ray.fragments.size(); ++i) {
        const Fragment& fragment = ray.fragments[i];
        PixelHistoryRow row{};
        row.fragment = i;
        row.absorbance = fragment_absorbance(fragment.opacity);
        row.true_transmittance = std::exp(-truth[i]);
        row.transmittance = estimates.empty() ? t[i] : estimates[i].transmittance;
        if (!estimates.empty()) {
            row.estimate = estimates[i];
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
