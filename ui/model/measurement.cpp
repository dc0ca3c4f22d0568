#include "ui/model/measurement.hpp"

#include <algorithm>
#include <cmath>

#include "core/inspect/exact_estimates.hpp"
#include "core/stress/classify.hpp"
#include "ui/model/selection.hpp"

namespace momentscope::ui {

namespace {

constexpr std::size_t SAMPLES = 512;

// Merges neighbouring depths where `is` holds into ranges.
template <typename Predicate>
std::vector<Range> ranges_where(const std::vector<float>& depths, const Predicate& is) {
    std::vector<Range> ranges;
    bool inside = false;
    for (std::size_t i = 0; i < depths.size(); ++i) {
        const bool goes_on = inside;
        inside = is(i);
        if (!inside) continue;
        if (!goes_on) ranges.push_back({depths[i], depths[i]});
        ranges.back().high = depths[i];
    }
    return ranges;
}

}  // namespace

const ViewRay& ray_of(const LightView& light, Viewpoint viewpoint) {
    return viewpoint == Viewpoint::opaque_casters ? light.opaque : light.ray;
}

std::vector<float> plot_depths(const ViewRay& ray, std::size_t samples, Range range) {
    std::vector<float> depths = even_depths(samples);
    for (float& depth : depths) depth = range.low + 0.5f * (depth + 1) * (range.high - range.low);
    constexpr std::size_t MAX_SAMPLED_FRAGMENTS = 1000;  // beyond that, samples are dense enough
    if (ray.fragments.size() > MAX_SAMPLED_FRAGMENTS) return depths;
    const float beside = 1e-3f * (range.high - range.low);  // less than a pixel of any plot
    for (const Fragment& fragment : ray.fragments)
        for (const float offset : {-beside, 0.0f, beside})
            depths.push_back(std::clamp(fragment.depth + offset, range.low, range.high));
    std::ranges::sort(depths);
    depths.erase(std::unique(depths.begin(), depths.end()), depths.end());
    return depths;
}

Range visible_depths(const ViewRay& ray, const PlotState& plot) {
    if (!plot.depth) return {-1, 1};
    const auto warped = [&](float at) {
        if (plot.axis == DepthAxis::warped || !ray.warp.has_view_depths()) return at;
        return at > 0 ? to_depth(at, ray.warp) : -1.0f;
    };
    Range range = {std::clamp(warped(plot.depth->low), -1.0f, 1.0f),
                   std::clamp(warped(plot.depth->high), -1.0f, 1.0f)};
    if (!(range.high - range.low > 1e-5f)) return {-1, 1};  // the depth range is out of sight
    return range;
}

float query_depth(const Measurement& measurement, const ExplorerState& state) {
    const ViewRay& ray = measurement.capture.ray;
    if (state.plot.query) return *state.plot.query;
    if (measurement.light && !state.marked) return measurement.light->bundle.place.depth;
    return state.marked && *state.marked < ray.fragments.size() ? ray.fragments[*state.marked].depth : 0.0f;
}

BoundViolation bound_violation(const Curve& curve) {
    BoundViolation exit;
    if (curve.beta0.empty()) return exit;
    const auto tolerance =
        static_cast<float>(2e-3 * std::max(curve.total_absorbance, 1e-6));  // about a pixel of the plot
    exit.where = ranges_where(curve.depth, [&](std::size_t i) {
        const auto truth = static_cast<float>(curve.truth[i]);
        const float by = std::max(curve.beta0[i] - truth, truth - curve.beta1[i]);
        if (by > exit.worst) {
            exit.worst = by;
            exit.worst_depth = curve.depth[i];
        }
        return by > tolerance;
    });
    return exit;
}

SolverFailure solver_failure(const Curve& curve) {
    SolverFailure failure;
    if (!curve.technique->has_moments() || !curve.parameters.textbook) return failure;
    const ReconstructionSettings settings = settings_of(curve.parameters);
    failure.where = ranges_where(curve.depth, [&](std::size_t i) {
        const float fraction =
            curve.technique->moment_kernel().fraction(curve.moments, settings, curve.depth[i]);
        failure.no_number |= std::isnan(fraction);
        return !(fraction >= -CLAMP_TOLERANCE && fraction <= 1 + CLAMP_TOLERANCE);
    });
    return failure;
}

bool same_curves(const ExplorerState& a, const ExplorerState& b) {
    const auto of_light_alone = [](ParameterId id) {
        return std::ranges::find(SHADOW_PARAMETERS, id) != SHADOW_PARAMETERS.end();
    };
    for (const Parameter& row : parameters())
        if (row.invalidates < Stage::composite && (seen_from_light(a) || !of_light_alone(row.id)) &&
            a.parameters[row.id] != b.parameters[row.id])
            return false;
    return a.technique == b.technique && seen_from_light(a) == seen_from_light(b) &&
           a.viewpoint == b.viewpoint && a.compared == b.compared && a.plot.depth == b.plot.depth &&
           a.plot.axis == b.plot.axis &&
           a.plot.shows(Series::unbiased_exact) == b.plot.shows(Series::unbiased_exact);
}

void measure_curves(Measurement& m, const ExplorerState& state) {
    const ViewRay& ray = m.capture.ray;
    const std::vector<float> depths = plot_depths(ray, SAMPLES, visible_depths(ray, state.plot));
    const auto [technique, values] = plotted_configuration(state);
    m.curve = sample_curve(ray, *technique, values, depths);
    m.exit = bound_violation(m.curve);
    m.failure = solver_failure(m.curve);
    m.compared.clear();
    for (const Technique* other : state.compared)
        if (other != technique) m.compared.push_back(sample_curve(ray, *other, values, depths));
    m.unbiased_exact = state.plot.shows(Series::unbiased_exact)
                           ? unbiased_absorbance(ray, *technique, m.curve.parameters, depths)
                           : std::vector<float>();
    m.history = pixel_history(ray, m.capture.transmittance, *technique, values);
    for (Pinned& pin : m.pins)
        pin.curve =
            sample_curve(pin.ray, *state.technique, state.parameters, plot_depths(pin.ray, SAMPLES / 2));
}

void measure_breakdown(Measurement& m, const ExplorerState& state) {
    m.breakdown = pixel_error_breakdown(m.capture.ray, *state.technique, state.parameters, m.capture.behind);
}

namespace {

// The marked fragment if the query lies at its depth, or another fragment there.
const Fragment* query_fragment(const Measurement& m, const ExplorerState& state, float query) {
    const std::vector<Fragment>& fragments = m.capture.ray.fragments;
    const bool marked =
        state.marked && *state.marked < fragments.size() && fragments[*state.marked].depth == query;
    return marked ? &fragments[*state.marked] : fragment_at(m.capture.ray, query);
}

}  // namespace

void measure_query(Measurement& m, const ExplorerState& state) {
    const float query = query_depth(m, state);
    m.canonical = canonical_representation(m.curve, query);
    m.steps = reconstruction_steps(m.curve, query, query_fragment(m, state, query));
}

std::string empty_ray_text(const Measurement& measurement) {
    return measurement.light ? "The light's map has no caster of this kind here."
                             : "No transparent surface covers this pixel. Click on one in the scene.";
}

}  // namespace momentscope::ui
