#include "ui/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ui/theme.hpp"

namespace momentscope::ui {

namespace {

constexpr float PI = 3.14159265f;

// Maps (depth, absorbance) to the screen.
struct Axes {
    ImVec2 upper_left, lower_right;  // of the area within the axes
    float depth_end;                 // right end; beyond 1 lies the wrapping zone
    float absorbance_end;

    float x(float depth) const {
        return upper_left.x + (depth + 1) / (depth_end + 1) * (lower_right.x - upper_left.x);
    }
    float y(float absorbance) const {
        return lower_right.y - absorbance / absorbance_end * (lower_right.y - upper_left.y);
    }
    ImVec2 point(float depth, float absorbance) const { return {x(depth), y(absorbance)}; }
};

// The depth at which a full turn of the circle ends: (z + 1)(pi - theta/2) = 2 pi.
float end_of_wrapping_zone(float theta) {
    return 2 * PI / (PI - 0.5f * theta) - 1;
}

bool has_wrapping_zone(const Curve& curve) {
    return curve.technique->uses(ParameterId::theta);
}

// A step of 1, 2 or 5 times a power of ten that gives about `count` ticks.
float tick_step(float range, float count) {
    const float rough = range / count;
    const float power = std::pow(10.0f, std::floor(std::log10(rough)));
    for (const float factor : {1.0f, 2.0f, 5.0f})
        if (factor * power >= rough) return factor * power;
    return 10 * power;
}

void draw_text(ImDrawList& list, ImVec2 at, ImVec2 anchor, const std::string& text,
               ImU32 tint = color::TEXT) {
    const ImVec2 extent = ImGui::CalcTextSize(text.c_str());
    list.AddText({at.x - anchor.x * extent.x, at.y - anchor.y * extent.y}, tint, text.c_str());
}

void draw_axes(ImDrawList& list, const Axes& axes, const ViewRay& ray) {
    const float line = ImGui::GetTextLineHeight();
    const float step = tick_step(axes.absorbance_end, 6);
    for (int i = 0; static_cast<float>(i) * step <= axes.absorbance_end; ++i) {
        const float value = static_cast<float>(i) * step;
        list.AddLine({axes.upper_left.x, axes.y(value)}, {axes.lower_right.x, axes.y(value)}, color::GRID);
        draw_text(list, {axes.upper_left.x - 6, axes.y(value)}, {1, 0.5f}, fmt::format("{:.4g}", value));
    }
    for (int i = -2; i <= 2; ++i) {
        const float depth = 0.5f * static_cast<float>(i);
        list.AddLine({axes.x(depth), axes.upper_left.y}, {axes.x(depth), axes.lower_right.y}, color::GRID);
        draw_text(list, {axes.x(depth), axes.lower_right.y + 3}, {0.5f, 0}, fmt::format("{:g}", depth));
    }
    const char* label = ray.warp.logarithmic ? "depth z (logarithm of view depth, mapped to [−1, 1])"
                                             : "depth z (linear, [−1, 1])";
    draw_text(list, {0.5f * (axes.upper_left.x + axes.lower_right.x), axes.lower_right.y + 4 + line},
              {0.5f, 0}, label);
    draw_text(list, {axes.upper_left.x, axes.upper_left.y - 4}, {0, 1}, "absorbance A(z) = −ln T(z), linear");
}

void draw_band(ImDrawList& list, const Axes& axes, const Curve& curve) {
    // Smoothed edges of neighbouring quads would overlap in visible stripes; the outline is drawn as lines.
    const ImDrawListFlags flags = list.Flags;
    list.Flags &= ~ImDrawListFlags_AntiAliasedFill;
    for (std::size_t i = 1; i < curve.depth.size(); ++i) {
        const ImVec2 quad[] = {
            axes.point(curve.depth[i - 1], curve.beta0[i - 1]), axes.point(curve.depth[i], curve.beta0[i]),
            axes.point(curve.depth[i], curve.beta1[i]), axes.point(curve.depth[i - 1], curve.beta1[i - 1])};
        list.AddQuadFilled(quad[3], quad[2], quad[1], quad[0], color::BAND);
    }
    list.Flags = flags;
}

void draw_line(ImDrawList& list, const Axes& axes, const Curve& curve, const std::vector<float>& values,
               ImU32 tint, float thickness) {
    std::vector<ImVec2> points;
    points.reserve(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) points.push_back(axes.point(curve.depth[i], values[i]));
    list.AddPolyline(points.data(), static_cast<int>(points.size()), tint, ImDrawFlags_None, thickness);
}

void draw_truth(ImDrawList& list, const Axes& axes, const ViewRay& ray) {
    float sum = 0;
    std::vector<ImVec2> points = {axes.point(-1, 0)};
    for (const std::size_t i : front_to_back(ray)) {
        const Fragment& fragment = ray.fragments[i];
        points.push_back(axes.point(fragment.depth, sum));
        sum += fragment_absorbance(fragment.opacity);
        points.push_back(axes.point(fragment.depth, sum));
    }
    points.push_back(axes.point(1, sum));
    list.AddPolyline(points.data(), static_cast<int>(points.size()), color::TRUTH, ImDrawFlags_None, 2.0f);
}

void draw_wrapping_zone(ImDrawList& list, const Axes& axes) {
    list.AddRectFilled({axes.x(1), axes.upper_left.y}, axes.lower_right, color::WRAPPING_ZONE);
    const float middle = 0.5f * (axes.x(1) + axes.lower_right.x);
    if (axes.lower_right.x - axes.x(1) > ImGui::CalcTextSize("θ").x)
        draw_text(list, {middle, axes.upper_left.y + 4}, {0.5f, 0}, "θ");
}

void draw_legend(ImDrawList& list, const Axes& axes, const ViewRay& ray, const Curve& curve) {
    struct Entry {
        const char* text;
        ImU32 tint;
    };
    std::vector<Entry> entries = {{"truth", color::TRUTH}};
    if (!curve.beta0.empty()) {
        entries.push_back({"reconstruction", color::RECONSTRUCTION});
        entries.push_back(
            {curve.technique->has_bounds ? "lower and upper bound" : "β = 0 and β = 1 (no bounds)",
             color::BOUNDS});
    }
    if (has_wrapping_zone(curve) && axes.depth_end > 1)
        entries.push_back({"wrapping zone θ", color::WRAPPING_ZONE});
    const float line = ImGui::GetTextLineHeight() + 3;
    ImVec2 extent = {0, line * static_cast<float>(entries.size())};
    for (const Entry& entry : entries) extent.x = std::max(extent.x, ImGui::CalcTextSize(entry.text).x + 30);
    // Absorbance only grows: where it grows late the upper left corner is empty, otherwise the lower right
    // one.
    const float middle[] = {0.0f};
    const bool late = 2 * true_absorbance(ray, middle).front() < curve.total_absorbance;
    const ImVec2 corner = late ? ImVec2(axes.upper_left.x + 14, axes.upper_left.y + 12)
                               : ImVec2(axes.x(1) - extent.x - 14, axes.lower_right.y - extent.y - 12);
    list.AddRectFilled({corner.x - 6, corner.y - 4}, {corner.x + extent.x + 6, corner.y + extent.y + 4},
                       color::LEGEND_BACKGROUND, 3);
    float y = corner.y;
    for (const Entry& entry : entries) {
        list.AddLine({corner.x, y + 0.5f * line}, {corner.x + 22, y + 0.5f * line},
                     entry.tint | IM_COL32(0, 0, 0, 255), 3);
        draw_text(list, {corner.x + 30, y}, {0, 0}, entry.text);
        y += line;
    }
}

}  // namespace

std::vector<float> plot_depths(const ViewRay& ray, std::size_t samples) {
    std::vector<float> depths = even_depths(samples);
    constexpr float BESIDE = 2e-3f;  // below one pixel of any plot
    for (const Fragment& fragment : ray.fragments)
        for (const float offset : {-BESIDE, 0.0f, BESIDE})
            depths.push_back(std::clamp(fragment.depth + offset, -1.0f, 1.0f));
    std::ranges::sort(depths);
    const auto repeated = std::ranges::unique(depths);
    depths.erase(repeated.begin(), repeated.end());
    return depths;
}

void draw_plot(const ViewRay& ray, const Curve& curve, ImVec2 upper_left, ImVec2 size) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float line = ImGui::GetTextLineHeight();
    const ImVec2 lower_right = {upper_left.x + size.x, upper_left.y + size.y};
    const float highest = curve.beta1.empty() ? 0.0f : *std::ranges::max_element(curve.beta1);
    const Axes axes = {{upper_left.x + 3.2f * line, upper_left.y + 1.6f * line},
                       {lower_right.x - line, lower_right.y - 2.6f * line},
                       has_wrapping_zone(curve) ? end_of_wrapping_zone(curve.parameters.theta) : 1.0f,
                       1.08f * std::max({static_cast<float>(curve.total_absorbance), highest, 1e-3f})};
    list.PushClipRect(upper_left, lower_right, true);
    list.AddRectFilled(axes.upper_left, axes.lower_right, color::PLOT_BACKGROUND);
    draw_axes(list, axes, ray);
    if (axes.depth_end > 1) draw_wrapping_zone(list, axes);
    if (!curve.beta0.empty()) {
        draw_band(list, axes, curve);
        draw_line(list, axes, curve, curve.beta0, color::BOUNDS, 1);
        draw_line(list, axes, curve, curve.beta1, color::BOUNDS, 1);
    }
    draw_truth(list, axes, ray);
    if (!curve.beta0.empty()) draw_line(list, axes, curve, curve.reconstructed, color::RECONSTRUCTION, 2);
    draw_legend(list, axes, ray, curve);
    if (ray.fragments.empty())
        draw_text(list,
                  {0.5f * (axes.upper_left.x + axes.lower_right.x),
                   0.5f * (axes.upper_left.y + axes.lower_right.y)},
                  {0.5f, 0.5f}, "No transparent surface covers this pixel. Click one in the scene.");
    list.PopClipRect();
}

}  // namespace momentscope::ui
