#include "ui/plot/plot_layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/inspect/ray_ends.hpp"
#include "ui/model/series.hpp"

namespace momentscope::ui {

namespace {

bool shows(const PlotInput& input, Series series) {
    return input.state.plot.shows(series);
}

// Fades all series except the one under the mouse in the legend.
ImU32 tint_of(const PlotInput& input, Series series, ImU32 tint) {
    if (!input.highlighted || *input.highlighted == series) return tint;
    const ImU32 opacity = ((tint >> IM_COL32_A_SHIFT) & 0xFF) / 4;
    return (tint & ~IM_COL32_A_MASK) | (opacity << IM_COL32_A_SHIFT);
}

float width_of(const PlotInput& input, Series series, float width) {
    const float scale = em() / 15;
    return scale * (input.highlighted == series ? 1.6f * width : width);
}

std::vector<ImVec2> points_of(const PlotAxes& axes, const std::vector<float>& depths,
                              const std::vector<float>& values) {
    std::vector<ImVec2> points;
    points.reserve(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) points.push_back(axes.point(depths[i], values[i]));
    return points;
}

void draw_band(ImDrawList& list, const PlotAxes& axes, const Curve& curve, ImU32 fill, ImU32 edge,
               float width) {
    // Smoothed edges of neighbouring quads would overlap in visible stripes. The outline is drawn as lines.
    const ImDrawListFlags flags = list.Flags;
    list.Flags &= ~ImDrawListFlags_AntiAliasedFill;
    const auto low = points_of(axes, curve.depth, curve.beta0);
    const auto high = points_of(axes, curve.depth, curve.beta1);
    for (std::size_t i = 1; i < low.size(); ++i)
        list.AddQuadFilled(high[i - 1], high[i], low[i], low[i - 1], fill);
    list.Flags = flags;
    draw_line(list, low, edge, width);
    draw_line(list, high, edge, width);
}

void draw_truth(ImDrawList& list, const PlotAxes& axes, const ViewRay& ray, ImU32 tint, float width) {
    float sum = 0;
    std::vector<ImVec2> points = {axes.point(-1, 0)};
    for (const std::size_t i : front_to_back(ray)) {
        const Fragment& fragment = ray.fragments[i];
        points.push_back(axes.point(fragment.depth, sum));
        sum += fragment_absorbance(fragment.opacity);
        points.push_back(axes.point(fragment.depth, sum));
    }
    points.push_back(axes.point(1, sum));
    draw_line(list, points, tint, width);
}

// The part of the circle beyond the depth range, where roots wrap from the far end to the near end.
void draw_wrapping_zone(ImDrawList& list, const PlotAxes& axes, const Palette& colors,
                        const PlotInput& input) {
    const Curve& curve = input.measurement.curve;
    const float begin = std::max(axes.x(1), axes.area.low.x);
    const float end = std::min(axes.x(end_of_circle(curve.parameters.theta)), axes.area.high.x);
    if (end <= begin) return;
    const ImU32 fill = tint_of(input, Series::wrapping_zone, colors.wrapping_zone_fill);
    const ImU32 edge = tint_of(input, Series::wrapping_zone, colors.wrapping_zone);
    list.AddRectFilled({begin, axes.area.low.y}, {end, axes.area.high.y}, fill);
    list.AddLine({begin, axes.area.low.y}, {begin, axes.area.high.y}, edge);
    const std::string label = fmt::format("θ = {:.2f}", curve.parameters.theta);
    const float room = ImGui::CalcTextSize(label.c_str()).x + 6;
    draw_text(list, {0.5f * (begin + end), axes.area.low.y + 4}, {0.5f, 0}, end - begin > room ? label : "θ",
              edge);
}

// Underlines the depth axis where the truth is outside the band.
void draw_exits(ImDrawList& list, const PlotAxes& axes, const Palette& colors, const Measurement& m) {
    const float y = axes.area.high.y - 3;
    for (const Range& range : m.exit.where)
        list.AddLine({axes.x(range.low) - 1, y}, {axes.x(range.high) + 1, y}, colors.exit, 4);
}

// Marks along the top the depths at which the solver fails.
void draw_failure(ImDrawList& list, const PlotAxes& axes, const Palette& colors, const Measurement& m) {
    const float tick = 0.5f * em();
    for (const Range& range : m.failure.where)
        for (int i = 0;; ++i) {
            const float x = axes.x(range.low) + 0.5f * tick * static_cast<float>(i);
            if (x > axes.x(range.high) + 0.5f) break;
            list.AddLine({x - 0.25f * tick, axes.area.low.y + tick}, {x + 0.25f * tick, axes.area.low.y + 1},
                         colors.exit, 1.5f);
        }
}

// A line from the truth to the reconstruction at every fragment's own depth: the error in the picture.
void draw_errors(ImDrawList& list, const PlotAxes& axes, const Palette& colors, const PlotInput& input) {
    constexpr std::size_t MAX_MARKED_FRAGMENTS = 300;  // more marks would hide the curves
    if (input.measurement.history.size() > MAX_MARKED_FRAGMENTS) return;
    const ImU32 tint = tint_of(input, Series::errors, colors.errors);
    const float scale = em() / 15;
    for (const PixelHistoryRow& row : input.measurement.history) {
        const float x = axes.x(input.measurement.capture.ray.fragments[row.fragment].depth);
        const auto y = [&](double t) {
            return axes.y(static_cast<float>(shown_absorbance(t, input.measurement.curve.total_absorbance)));
        };
        const float from = y(row.true_transmittance);
        const float to = y(static_cast<double>(row.transmittance));
        list.AddLine({x, from}, {x, to}, tint, width_of(input, Series::errors, 2));
        list.AddCircleFilled({x, to}, 3.2f * scale, tint);
    }
}

// What the moments leave open at every fragment.
void draw_intervals(ImDrawList& list, const PlotAxes& axes, const Palette& colors, const PlotInput& input) {
    constexpr std::size_t MAX_INTERVALS = 300;
    const Measurement& m = input.measurement;
    const float scale = em() / 15;
    const ImU32 tint = tint_of(input, Series::bounds, colors.bounds);
    const float width = width_of(input, Series::bounds, 1.5f);
    if (!m.curve.parameters.is_published() && m.history.size() <= MAX_INTERVALS)
        for (const PixelHistoryRow& row : m.history) {
            if (!row.estimate) continue;
            const float x = axes.x(m.capture.ray.fragments[row.fragment].depth);
            const float low = axes.y(row.estimate->lower), high = axes.y(row.estimate->upper);
            list.AddLine({x, low}, {x, high}, tint, width);
            for (const float y : {low, high})
                list.AddLine({x - 3 * scale, y}, {x + 3 * scale, y}, tint, width);
        }
}

// The ends of the ray as brackets on the depth axis.
void draw_ends(ImDrawList& list, const PlotAxes& axes, const Palette& colors, const Measurement& m) {
    const float scale = em() / 15;
    const auto ends = ray_ends(m.curve.moments);
    if (!ends) return;
    const float bottom = axes.area.high.y, top = bottom - 14 * scale;
    for (const auto& [depth, inwards] :
         {std::pair(ends->near, 5 * scale), std::pair(ends->far, -5 * scale)}) {
        const float x = axes.x(depth);
        for (const float y : {top, bottom}) list.AddLine({x, y}, {x + inwards, y}, colors.text, 2 * scale);
        list.AddLine({x, top}, {x, bottom}, colors.text, 2 * scale);
    }
}

// The canonical representation: one stem per mass, as high as its absorbance.
void draw_stems(ImDrawList& list, const PlotAxes& axes, const Palette& colors, const PlotInput& input) {
    const CanonicalRepresentation& canonical = input.measurement.canonical;
    const float b0 = input.measurement.curve.moments.b0;
    if (!(b0 > 0)) return;
    const float scale = em() / 15;
    const ImU32 tint = tint_of(input, Series::stems, colors.stems);
    // In a plot of T, the height of a stem is its share of b0.
    const auto top = [&](float absorbance) {
        return axes.y_of(axes.quantity == Quantity::absorbance ? absorbance : absorbance / b0);
    };
    const float ground = axes.y_of(0);
    const float width = width_of(input, Series::stems, 2);
    for (const PointMass& node : canonical.nodes) {
        if (!std::isfinite(node.depth)) continue;
        const ImVec2 head = {axes.x(node.depth), top(node.absorbance)};
        list.AddLine({head.x, ground}, head, tint, width);
        if (node.value > 0.5f)  // full head: counts as in front
            list.AddCircleFilled(head, 4.2f * scale, tint);
        else
            list.AddCircle(head, 4.2f * scale, tint, 0, 1.6f * scale);
    }
    const float x = axes.x(canonical.query);
    list.AddLine({x, ground}, {x, top(canonical.query_absorbance)}, tint, width);
    list.AddQuadFilled({x - 5 * scale, top(canonical.query_absorbance)},
                       {x, top(canonical.query_absorbance) - 5 * scale},
                       {x + 5 * scale, top(canonical.query_absorbance)},
                       {x, top(canonical.query_absorbance) + 5 * scale}, tint);
}

// How the estimate is chosen between the bounds at the query.
std::string query_label(const Measurement& measurement) {
    const ResolvedParameters& parameters = measurement.curve.parameters;
    const RayEnd end = measurement.steps.end;
    if (end == RayEnd::near || end == RayEnd::far) return end == RayEnd::near ? "near end" : "far end";
    const bool mean = parameters.estimation.estimate == Estimate::expected;
    return mean ? "mean of T" : fmt::format("β = {:.2f}", parameters.beta);
}

// Shows where the estimate lies between the two bounds at the query depth.
void draw_query(ImDrawList& list, const PlotAxes& axes, const Palette& colors, const PlotInput& input) {
    const CanonicalRepresentation& canonical = input.measurement.canonical;
    const float scale = em() / 15;
    const float x = axes.x(canonical.query);
    draw_dashed(list, {{x, axes.area.low.y}, {x, axes.area.high.y}}, colors.axis, scale, {3, 5});
    list.AddTriangleFilled({x - 6 * scale, axes.area.high.y + 1}, {x + 6 * scale, axes.area.high.y + 1},
                           {x, axes.area.high.y - 7 * scale}, colors.text);
    if (!(input.measurement.curve.moments.b0 > 0) || !shows(input, Series::bounds)) return;
    const float b0 = input.measurement.curve.moments.b0;
    const float beta = input.measurement.curve.parameters.beta;
    const bool published = input.measurement.curve.parameters.is_published();
    const Steps& steps = input.measurement.steps;
    const float front = canonical.in_front, here = canonical.query_absorbance;
    const float low = std::clamp(published ? front : steps.lower, 0.0f, b0);
    const float high = std::clamp(published ? front + here : steps.upper, 0.0f, b0);
    const float at = std::clamp(published ? front + beta * here : steps.absorbance, 0.0f, b0);
    const ImU32 tint = tint_of(input, Series::bounds, colors.bounds);
    const float bar = 7 * scale;
    list.AddLine({x, axes.y(low)}, {x, axes.y(high)}, tint, 2 * scale);
    for (const float end : {low, high})
        list.AddLine({x - bar, axes.y(end)}, {x + bar, axes.y(end)}, tint, 2 * scale);
    const float y = axes.y(at);
    const ImU32 fill = tint_of(input, Series::reconstruction, colors.reconstruction);
    list.AddQuadFilled({x - 5 * scale, y}, {x, y - 5 * scale}, {x + 5 * scale, y}, {x, y + 5 * scale}, fill);
    const std::string label = query_label(input.measurement);
    const bool right = x + ImGui::CalcTextSize(label.c_str()).x + 2 * bar < axes.area.high.x;
    const float height = 0.5f * ImGui::GetTextLineHeight();
    const float text_y = std::clamp(y, axes.area.low.y + height, axes.area.high.y - height);
    const ImVec2 extent = ImGui::CalcTextSize(label.c_str());
    const float text_x = right ? x + 1.6f * bar : x - 1.6f * bar - extent.x;
    // Cover the curves behind the label.
    list.AddRectFilled({text_x - 3, text_y - height}, {text_x + extent.x + 3, text_y + height},
                       colors.plot_background, 3);
    draw_text(list, {text_x, text_y}, {0, 0.5f}, label, fill);
}

void draw_marked(ImDrawList& list, const PlotAxes& axes, const Palette& colors, const PlotInput& input) {
    const auto& fragments = input.measurement.capture.ray.fragments;
    if (!input.state.marked || *input.state.marked >= fragments.size()) return;
    const float x = axes.x(fragments[*input.state.marked].depth);
    const float scale = em() / 15;
    list.AddRectFilled({x - 4 * scale, axes.area.low.y}, {x + 4 * scale, axes.area.high.y}, colors.grid);
    list.AddTriangleFilled({x - 6 * scale, axes.area.low.y - 1}, {x + 6 * scale, axes.area.low.y - 1},
                           {x, axes.area.low.y + 8 * scale}, colors.text);
}

}  // namespace

ImVec2 dash_of(std::size_t i) {
    // Five patterns and four colours make twenty techniques look different.
    static const ImVec2 DASHES[] = {{10, 4}, {3, 3}, {14, 3}, {2, 5}, {5, 2}};
    return DASHES[i % std::size(DASHES)];
}

void draw_layers(ImDrawList& list, const PlotAxes& axes, const Palette& colors, const PlotInput& input) {
    const Measurement& m = input.measurement;
    const Curve& curve = m.curve;
    if (curve.technique->uses(ParameterId::theta) && shows(input, Series::wrapping_zone))
        draw_wrapping_zone(list, axes, colors, input);
    draw_marked(list, axes, colors, input);
    if (!curve.beta0.empty() && shows(input, Series::bounds)) {
        draw_band(list, axes, curve, tint_of(input, Series::bounds, colors.band),
                  tint_of(input, Series::bounds, colors.bounds), width_of(input, Series::bounds, 1));
        draw_exits(list, axes, colors, m);
        draw_intervals(list, axes, colors, input);
    }
    if (shows(input, Series::truth))  // so wide that it stays visible under a curve that lies on it
        draw_truth(list, axes, m.capture.ray, tint_of(input, Series::truth, colors.truth),
                   width_of(input, Series::truth, 3.6f));
    for (std::size_t i = 0; i < m.compared.size(); ++i)
        draw_dashed(list, points_of(axes, m.compared[i].depth, m.compared[i].reconstructed),
                    tint_of(input, Series::reconstruction, colors.compared[i % colors.compared.size()]),
                    width_of(input, Series::reconstruction, 1.6f), dash_of(i));
    for (const auto* bound : {&m.sharp.lower, &m.sharp.upper})
        draw_dashed(list, points_of(axes, m.sharp.depth, *bound), tint_of(input, Series::sharp, colors.sharp),
                    width_of(input, Series::sharp, 1.6f), SHARP_DASH);
    if (!m.unbiased_exact.empty())
        draw_dashed(list, points_of(axes, curve.depth, m.unbiased_exact),
                    tint_of(input, Series::unbiased_exact, colors.unbiased_exact),
                    width_of(input, Series::unbiased_exact, 1.8f), UNBIASED_EXACT_DASH);
    if (has_function(*curve.technique) && shows(input, Series::reconstruction))
        draw_line(list, points_of(axes, curve.depth, curve.reconstructed),
                  tint_of(input, Series::reconstruction, colors.reconstruction),
                  width_of(input, Series::reconstruction, 1.7f));
    if (shows(input, Series::reconstruction)) draw_failure(list, axes, colors, m);
    if (shows(input, Series::stems)) draw_stems(list, axes, colors, input);
    if (shows(input, Series::errors) && has_series(Series::errors, *curve.technique))
        draw_errors(list, axes, colors, input);
    draw_query(list, axes, colors, input);
    if (shows(input, Series::bounds)) draw_ends(list, axes, colors, m);
}

void draw_small_layers(ImDrawList& list, const PlotAxes& axes, const Palette& colors, const ViewRay& ray,
                       const Curve& curve) {
    if (!curve.beta0.empty()) draw_band(list, axes, curve, colors.band, colors.bounds, 1);
    draw_truth(list, axes, ray, colors.truth, 1.6f);
    if (has_function(*curve.technique))
        draw_line(list, points_of(axes, curve.depth, curve.reconstructed), colors.reconstruction, 1.6f);
}

}  // namespace momentscope::ui
