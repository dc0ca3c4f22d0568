#include "ui/plot/plot_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace momentscope::ui {

namespace {

bool has_wrapping_zone(const Curve& curve, const PlotState& plot) {
    return curve.technique->uses(ParameterId::theta) && plot.shows(Series::wrapping_zone);
}

Range fitting_depths(const PlotAxes& axes, const Curve& curve, const PlotState& plot) {
    const float low = axes.axis_of(-1);
    const float high = axes.axis_of(1);
    if (!has_wrapping_zone(curve, plot)) return {low, high};
    // In view depth the zone grows exponentially, so only a part of it is shown.
    constexpr float MAX_ZONE = 0.2f;
    const float end = axes.axis_of(end_of_circle(curve.parameters.theta));
    if (axes.axis == DepthAxis::view) return {low, std::min(end, high + MAX_ZONE * (high - low))};
    return {low, std::max(end, high)};
}

Range fitting_values(const Curve& curve, Quantity quantity) {
    if (quantity == Quantity::transmittance) return {0, 1.04f};
    float highest = 1e-3f;
    const auto reach = [&](float value) {  // the axis must stay finite
        if (std::isfinite(value)) highest = std::max(highest, value);
    };
    reach(static_cast<float>(curve.total_absorbance));
    for (const float value : curve.beta1) reach(value);
    return {0, 1.08f * highest};
}

// A step of 1, 2 or 5 times a power of ten that gives about `count` ticks.
float tick_step(float range, float count) {
    const float rough = range / count;
    const float power = std::pow(10.0f, std::floor(std::log10(rough)));
    for (const float factor : {1.0f, 2.0f, 5.0f})
        if (factor * power >= rough) return factor * power;
    return 10 * power;
}

// Rounds to the step, so that 0.30000001 is written as 0.3.
std::string tick_label(float value, float step) {
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-3f)), 0, 7);
    return fmt::format("{:.{}f}", static_cast<double>(value == 0 ? 0.0f : value), decimals);
}

template <typename Draw>
void for_each_tick(const Range& range, float count, const Draw& draw) {
    const float step = tick_step(range.high - range.low, std::max(count, 2.0f));
    const auto first = static_cast<long>(std::ceil(range.low / step));
    const auto last = static_cast<long>(std::floor(range.high / step));
    for (long i = first; i <= last && i - first < 100; ++i) {
        const float value = static_cast<float>(i) * step;
        draw(value, tick_label(value, step));
    }
}

// The name of an axis without its explanation in parentheses, or after a comma, if the whole is too wide.
std::string fitting_name(const std::string& name, float width) {
    if (ImGui::CalcTextSize(name.c_str()).x <= width) return name;
    const auto end = std::min(name.find(" ("), name.find(", "));
    return name.substr(0, end);
}

}  // namespace

float PlotAxes::axis_of(float warped_depth) const {
    return axis == DepthAxis::view && warp.has_view_depths() ? to_view_depth(warped_depth, warp)
                                                             : warped_depth;
}

float PlotAxes::warped_of(float axis_value) const {
    if (axis != DepthAxis::view || !warp.has_view_depths()) return axis_value;
    return axis_value > 0 ? to_depth(axis_value, warp) : -1.0f;
}

float PlotAxes::shown(float absorbance) const {
    return quantity == Quantity::absorbance ? absorbance : transmittance(absorbance);
}

PlotAxes make_axes(const ViewRay& ray, const Curve& curve, const PlotState& plot, const Rect& outside,
                   bool labels) {
    PlotAxes axes;
    axes.quantity = plot.quantity;
    axes.axis = plot.axis;
    axes.warp = ray.warp;
    const float line = ImGui::GetTextLineHeight();
    axes.area = outside;
    if (labels) {
        axes.area.low.x += 3.1f * line;
        axes.area.low.y += 1.4f * line;
        axes.area.high.x -= 0.8f * line;
        axes.area.high.y -= 2.4f * line;
    }
    axes.area.high.x = std::max(axes.area.high.x, axes.area.low.x + 1);
    axes.area.high.y = std::max(axes.area.high.y, axes.area.low.y + 1);
    axes.depth = plot.depth.value_or(fitting_depths(axes, curve, plot));
    axes.value = plot.value.value_or(fitting_values(curve, plot.quantity));
    return axes;
}

void draw_axes(ImDrawList& list, const PlotAxes& axes, const Palette& colors, bool labels) {
    const float line = ImGui::GetTextLineHeight();
    const Rect& area = axes.area;
    const float x_count = (area.high.x - area.low.x) / (5 * line);
    const float y_count = (area.high.y - area.low.y) / (2.6f * line);
    for_each_tick(axes.depth, x_count, [&](float value, const std::string& label) {
        const float x = axes.x_of(value);
        list.AddLine({x, area.low.y}, {x, area.high.y}, colors.grid);
        if (labels) draw_text(list, {x, area.high.y + 3}, {0.5f, 0}, label, colors.text);
    });
    for_each_tick(axes.value, y_count, [&](float value, const std::string& label) {
        const float y = axes.y_of(value);
        list.AddLine({area.low.x, y}, {area.high.x, y}, colors.grid);
        if (labels) draw_text(list, {area.low.x - 0.4f * line, y}, {1, 0.5f}, label, colors.text);
    });
    list.AddRect(area.low, area.high, colors.grid);
    if (!labels) return;
    const char* depth_name =
        !axes.warp.has_view_depths() ? "depth z (linear, [−1, 1])"
        : axes.warp.kind == DepthWarp::Kind::linear
            ? axes.axis == DepthAxis::warped ? "depth z seen from the light (linear, mapped to [−1, 1])"
                                             : "depth seen from the light (linear, scene units)"
        : axes.axis == DepthAxis::warped ? "depth z (logarithm of view depth, mapped to [−1, 1])"
                                         : "view depth (linear, scene units)";
    const char* value_name = axes.value_name != nullptr ? axes.value_name
                             : axes.quantity == Quantity::absorbance
                                 ? "absorbance A(z) = −ln T(z), linear"
                                 : "transmittance T(z) = exp(−A(z)), linear";
    const float width = area.high.x - area.low.x;
    draw_text(list, {0.5f * (area.low.x + area.high.x), area.high.y + 4 + line}, {0.5f, 0},
              fitting_name(depth_name, width), colors.text);
    draw_text(list, {area.low.x, area.low.y - 3}, {0, 1}, fitting_name(value_name, width), colors.text);
}

void draw_text(ImDrawList& list, ImVec2 at, ImVec2 anchor, const std::string& text, ImU32 tint) {
    const ImVec2 extent = ImGui::CalcTextSize(text.c_str());
    list.AddText({at.x - anchor.x * extent.x, at.y - anchor.y * extent.y}, tint, text.c_str());
}

}  // namespace momentscope::ui
