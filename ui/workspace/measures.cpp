#include "ui/workspace/measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace momentscope::ui {

namespace {

constexpr double SMALL_MASS = 0.01;  // share of b0; smaller ones come from bias

double fragment_count(const Workspace& w) {
    return static_cast<double>(w.measurement().capture.ray.fragments.size());
}

const PixelHistoryRow* marked_row(const Workspace& w) {
    const auto& rows = w.measurement().history;
    const auto row = std::ranges::find(rows, w.shown.marked,
                                       [](const PixelHistoryRow& r) { return std::optional(r.fragment); });
    return row == rows.end() ? nullptr : &*row;
}

std::optional<double> measure_fragments(const Workspace& w) {
    return fragment_count(w);
}

std::optional<double> measure_total_absorbance(const Workspace& w) {
    return w.measurement().curve.total_absorbance;
}

std::optional<double> measure_total_transmittance(const Workspace& w) {
    return std::exp(-w.measurement().curve.total_absorbance);
}

std::optional<double> measure_absorbance_in_front(const Workspace& w) {
    const float query = query_depth(w.measurement(), w.shown);
    return true_absorbance(w.measurement().capture.ray, {&query, 1}).front();
}

std::optional<double> measure_transmittance_in_front(const Workspace& w) {
    return std::exp(-*measure_absorbance_in_front(w));
}

// Steps are measured for techniques with moments on rays that are not empty.
const Steps* steps_of(const Workspace& w) {
    const Measurement& m = w.measurement();
    return m.curve.technique->has_moments() && !m.steps.empty ? &m.steps : nullptr;
}

std::optional<double> measure_reconstructed_absorbance(const Workspace& w) {
    const Steps* steps = steps_of(w);
    return steps == nullptr ? std::nullopt : std::optional(static_cast<double>(steps->absorbance));
}

std::optional<double> normalised_moment(const Workspace& w, std::size_t index) {
    const Steps* steps = steps_of(w);
    return steps == nullptr ? std::nullopt : std::optional(static_cast<double>(steps->normalised.b[index]));
}

std::optional<double> measure_moment_1(const Workspace& w) {
    return normalised_moment(w, 0);
}

std::optional<double> measure_moment_2(const Workspace& w) {
    return normalised_moment(w, 1);
}

std::optional<double> measure_moment_count(const Workspace& w) {
    const Technique& technique = *w.shown.technique;
    return technique.has_moments() ? std::optional(technique.moments().moment_count) : std::nullopt;
}

std::optional<double> measure_masses(const Workspace& w) {
    if (steps_of(w) == nullptr) return std::nullopt;
    const CanonicalRepresentation& canonical = w.measurement().canonical;
    const double least = SMALL_MASS * w.measurement().curve.total_absorbance;
    const auto counts = [&](float mass) { return static_cast<double>(mass) > least; };
    const auto nodes = std::ranges::count_if(canonical.nodes,
                                             [&](const PointMass& node) { return counts(node.absorbance); });
    return static_cast<double>(nodes + (counts(canonical.query_absorbance) ? 1 : 0));
}

std::optional<double> measure_gap(const Workspace& w) {
    if (steps_of(w) == nullptr) return std::nullopt;
    return w.measurement().canonical.query_absorbance;
}

std::optional<double> measure_gap_share(const Workspace& w) {
    const Curve& curve = w.measurement().curve;
    float widest = 0;
    for (std::size_t i = 0; i < curve.beta0.size(); ++i)
        widest = std::max(widest, curve.beta1[i] - curve.beta0[i]);
    const auto gap = measure_gap(w);
    return gap && widest > 0 ? std::optional(*gap / static_cast<double>(widest)) : std::nullopt;
}

std::optional<double> measure_marked_transmittance(const Workspace& w) {
    const PixelHistoryRow* row = marked_row(w);
    return row == nullptr ? std::nullopt : std::optional(row->true_transmittance);
}

std::optional<double> measure_marked_estimate(const Workspace& w) {
    const PixelHistoryRow* row = marked_row(w);
    return row == nullptr ? std::nullopt : std::optional(static_cast<double>(row->transmittance));
}

std::optional<double> measure_marked_error(const Workspace& w) {
    const PixelHistoryRow* row = marked_row(w);
    return row == nullptr ? std::nullopt : std::optional(std::abs(row->error()));
}

std::optional<double> measure_greatest_error(const Workspace& w) {
    double greatest = 0;
    for (const PixelHistoryRow& row : w.measurement().history)
        greatest = std::max(greatest, std::abs(row.error()));
    return greatest;
}

std::optional<double> measure_error_between(const Workspace& w) {
    const Measurement& m = w.measurement();
    if (steps_of(w) == nullptr) return std::nullopt;
    std::vector<float> depths = own_depths(m.capture.ray);
    std::ranges::sort(depths);
    std::vector<float> between;
    for (std::size_t i = 0; i + 1 < depths.size(); ++i) between.push_back(0.5f * (depths[i] + depths[i + 1]));
    const Curve curve = sample_curve(m.capture.ray, *m.curve.technique, m.curve.values, between);
    double greatest = 0;
    for (std::size_t i = 0; i < between.size(); ++i)
        greatest = std::max(greatest, std::abs(static_cast<double>(curve.reconstructed[i]) - curve.truth[i]));
    return greatest;
}

std::optional<double> measure_color_error(const Workspace& w) {
    if (w.measurement().light) return std::nullopt;
    return w.measurement().breakdown.error;
}

std::optional<double> measure_failed_pixels(const Workspace& w) {
    if (!w.scene_picture.failures || w.shown.ray) return std::nullopt;
    return static_cast<double>(w.scene_picture.failures->failed);
}

std::optional<double> measure_picture_error(const Workspace& w) {
    if (w.shown.ray) return std::nullopt;
    if (!has_comparison(w.shown)) return 0;  // it is the reference itself
    const Comparison& numbers = w.comparison.numbers();
    const MetricResult* result = numbers.result(Metric::rmse);
    return result != nullptr && numbers.is_fresh(Metric::rmse) ? std::optional(result->mean) : std::nullopt;
}

std::optional<double> measure_bits(const Workspace& w) {
    return stored_bits(*w.shown.technique, w.shown.parameters);
}

}  // namespace

std::optional<double> measured(MeasureId id, const Workspace& w) {
    constexpr std::array MEASURE_OF = {
#define MEASURE(id, name, digits, help) measure_##id,
#include "ui/model/measures.def"
#undef MEASURE
    };
    return w.picked.empty() ? std::nullopt : MEASURE_OF[static_cast<std::size_t>(id)](w);
}

std::string measure_text(MeasureId id, const Workspace& w) {
    const auto value = measured(id, w);
    return value ? fmt::format("{:.{}f}", *value, MEASURES[static_cast<std::size_t>(id)].digits) : "–";
}

}  // namespace momentscope::ui
