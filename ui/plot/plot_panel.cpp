#include "ui/plot/plot_panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/inspect/exact_estimates.hpp"
#include "ui/model/selection.hpp"
#include "ui/plot/plot_layers.hpp"
#include "ui/plot/plot_legend.hpp"
#include "ui/plot/plot_notes.hpp"
#include "ui/plot/plot_tools.hpp"

namespace momentscope::ui {

namespace {

// A button that opens the legend where there is no room for it.
std::optional<Series> draw_legend_button(const Ui& ui, const Measurement& m, ExplorerState& state,
                                         float right) {
    flow(button_width("legend"), right, em());
    if (ImGui::Button("legend")) ImGui::OpenPopup("legend");
    ui.record_widget_rect("plot.legend");
    tooltip("Names the curves, and shows or hides them.");
    if (!ImGui::BeginPopup("legend")) return std::nullopt;
    const std::optional<Series> hovered = draw_legend(ui, m, state, ImGui::GetCursorScreenPos().x);
    ImGui::EndPopup();
    return hovered;
}

// The fragment whose step is nearest to the mouse, if it is near enough.
std::optional<std::size_t> fragment_at(const PlotAxes& axes, const ViewRay& ray, float x) {
    std::optional<std::size_t> nearest;
    float least = 0.35f * em();
    for (std::size_t i = 0; i < ray.fragments.size(); ++i) {
        const float distance = std::abs(axes.x(ray.fragments[i].depth) - x);
        if (distance > least) continue;
        least = distance;
        nearest = i;
    }
    return nearest;
}

void value_line(const char* name, ImU32 tint, float absorbance, const PlotAxes& axes) {
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(tint), "%s", name);
    ImGui::SameLine(11 * em());
    ImGui::Text("%s = %.5f", axes.quantity == Quantity::absorbance ? "A" : "T",
                static_cast<double>(axes.shown(absorbance)));
}

// Draws the crosshair and lists the values of all curves at the mouse.
void draw_crosshair(const Ui& ui, const PlotAxes& axes, const Measurement& m, const ExplorerState& state) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const float warped = axes.warped_of(axes.depth_at(mouse.x));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddLine({mouse.x, axes.area.low.y}, {mouse.x, axes.area.high.y}, ui.colors.axis);
    list.AddLine({axes.area.low.x, mouse.y}, {axes.area.high.x, mouse.y}, ui.colors.grid);
    const float at_mouse = axes.depth_at(mouse.x);  // not clamped to the depth range, unlike `warped`
    if (!(at_mouse >= axes.axis_of(-1) && at_mouse <= axes.axis_of(1))) return;
    const ViewRay& ray = m.capture.ray;
    const float at[] = {warped};
    ImGui::BeginTooltip();
    ImGui::Text("z = %.4f", static_cast<double>(warped));
    if (ray.warp.has_view_depths()) {
        ImGui::SameLine(11 * em());
        ImGui::Text("view depth %.4f", static_cast<double>(to_view_depth(warped, ray.warp)));
    }
    const Curve curve = sample_curve(ray, *m.curve.technique, m.curve.values, at);
    value_line("truth", ui.colors.truth, static_cast<float>(curve.truth[0]), axes);
    if (has_function(*curve.technique))
        value_line("reconstruction", ui.colors.reconstruction, curve.reconstructed[0], axes);
    if (!curve.beta0.empty() && state.plot.shows(Series::bounds)) {
        value_line(curve.technique->has_bounds() ? "lower bound of A" : "β = 0", ui.colors.bounds,
                   curve.beta0[0], axes);
        value_line(curve.technique->has_bounds() ? "upper bound of A" : "β = 1", ui.colors.bounds,
                   curve.beta1[0], axes);
    }
    const auto unbiased_exact = m.unbiased_exact.empty()
                                    ? std::vector<float>()
                                    : unbiased_absorbance(ray, *m.curve.technique, curve.parameters, at);
    if (!unbiased_exact.empty())
        value_line("exact, no bias", ui.colors.unbiased_exact, unbiased_exact[0], axes);
    for (std::size_t i = 0; i < m.compared.size(); ++i)
        value_line(m.compared[i].technique->id, ui.colors.compared[i % ui.colors.compared.size()],
                   sample_curve(ray, *m.compared[i].technique, m.compared[i].values, at).reconstructed[0],
                   axes);
    ImGui::EndTooltip();
}

// Where there is little room, in one line, of which the tooltip has the rest.
void draw_note(const Ui& ui, const std::string& note, float right, bool room) {
    if (note.empty()) return;
    if (!room) {
        const float width = right - ImGui::GetCursorScreenPos().x;
        ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(ui.colors.exit), "%s", elided(note, width).c_str());
        return tooltip(note);
    }
    ImGui::PushTextWrapPos(right - ImGui::GetWindowPos().x);
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(ui.colors.exit), "%s", note.c_str());
    ImGui::PopTextWrapPos();
}

// Describes the receiver of the light and how much light reaches it.
void draw_light_line(const Ui& ui, const Measurement& m, float right) {
    if (!m.light) return;
    ImGui::PushTextWrapPos(right - ImGui::GetWindowPos().x);
    ImGui::TextWrapped("Receiver: %s, at z = %.3f. %s", m.light->receiver.c_str(),
                       static_cast<double>(m.light->bundle.place.depth), m.light->breakdown.sentence.c_str());
    ImGui::PopTextWrapPos();
    ui.record_widget_rect("plot.receiver");
    tooltip(
        "The receiver of the light in the picked pixel: the marked fragment, or the one with which the pixel is half "
        "covered, or else the opaque surface. To choose another one, mark a fragment of the eye's ray. The plotted "
        "truth is the mixture of the filter's texels.");
}

bool contains(const Rect& rect, ImVec2 at) {
    return at.x >= rect.low.x && at.x < rect.high.x && at.y >= rect.low.y && at.y < rect.high.y;
}

}  // namespace

void PlotPanel::zoom(const PlotAxes& axes, PlotState& plot, bool depth, bool value, float notches) const {
    const float factor = std::pow(0.85f, notches);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const auto around = [&](const Range& range, float fixed) {
        return Range{fixed + (range.low - fixed) * factor, fixed + (range.high - fixed) * factor};
    };
    constexpr float MIN_EXTENT = 1e-4f, MAX_EXTENT = 1e4f;  // beyond, floats have too few digits for ticks
    const auto sensible = [](const Range& range) {
        return range.high - range.low > MIN_EXTENT && range.high - range.low < MAX_EXTENT;
    };
    const Range new_depth = around(axes.depth, axes.depth_at(mouse.x));
    const Range new_value = around(axes.value, axes.value_at(mouse.y));
    if (depth && sensible(new_depth)) plot.depth = new_depth;
    if (value && sensible(new_value)) plot.value = new_value;
}

void PlotPanel::pan(const PlotAxes& axes, PlotState& plot) const {
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    if (grips_depth_ && moved.x != 0) {
        const float by = axes.depth_at(axes.area.low.x - moved.x) - axes.depth.low;
        plot.depth = Range{axes.depth.low + by, axes.depth.high + by};
    }
    if (grips_value_ && moved.y != 0) {
        const float by = axes.value_at(axes.area.high.y - moved.y) - axes.value.low;
        plot.value = Range{axes.value.low + by, axes.value.high + by};
    }
}

void PlotPanel::handle_mouse(const PlotAxes& axes, const Measurement& m, ExplorerState& state) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool inside = contains(axes.area, io.MousePos);
    const bool on_value_axis = io.MousePos.x < axes.area.low.x;
    const bool on_depth_axis = io.MousePos.y >= axes.area.high.y && !on_value_axis;
    if (ImGui::IsItemHovered() && io.MouseWheel != 0)
        zoom(axes, state.plot, !on_value_axis, !on_depth_axis, io.MouseWheel);
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        if (!on_value_axis) fit_depths(state.plot);
        if (!on_depth_axis) fit_values(state.plot);
        if (inside) {  // the first click must not change the query depth
            state.plot.query = query_before_click_;
            state.marked = marked_before_click_;
        }
        grip_ = Grip::none;
        return;
    }
    if (ImGui::IsItemActivated()) {
        grip_ = inside && ImGui::IsMouseDown(ImGuiMouseButton_Left) ? Grip::query : Grip::pan;
        grips_depth_ = inside || on_depth_axis;
        grips_value_ = inside || on_value_axis;
        query_before_click_ = state.plot.query;
        marked_before_click_ = state.marked;
        if (grip_ == Grip::query) state.marked = fragment_at(axes, m.capture.ray, io.MousePos.x);
    }
    if (!ImGui::IsItemActive()) {
        grip_ = Grip::none;
        return;
    }
    if (grip_ == Grip::pan) pan(axes, state.plot);
    if (grip_ == Grip::query) {
        // A click on a step snaps to its fragment; dragging ends the snap.
        const bool snapped = state.marked && !ImGui::IsMouseDragging(ImGuiMouseButton_Left);
        const float at = axes.warped_of(axes.depth_at(io.MousePos.x));
        state.plot.query = snapped ? std::nullopt : std::optional(std::clamp(at, -1.0f, 1.0f));
    }
}

void PlotPanel::draw(const Ui& ui, const Measurement& m, ExplorerState& state, ImVec2 size) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float right = corner.x + size.x;
    ImGui::BeginGroup();
    ImGui::PushID("plot panel");
    const float legend = legend_height(m, size.x);
    const bool fits = size.y - beside_curves_ - legend >= LEAST_PLOT * em();
    draw_plot_tools(ui, m, state, right);
    const std::optional<Series> hovered =
        fits ? draw_legend(ui, m, state, right) : draw_legend_button(ui, m, state, right);
    draw_light_line(ui, m, right);
    if (state.plot.shows(Series::reconstruction)) draw_note(ui, failure_note(m), right, fits);
    if (state.plot.shows(Series::bounds) && m.failure.where.empty()) draw_note(ui, band_note(m), right, fits);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 extent = {std::max(size.x, 1.0f), std::max(corner.y + size.y - low.y, 1.0f)};
    const Rect outside = {low, {low.x + extent.x, low.y + extent.y}};
    ImGui::InvisibleButton("plot", extent,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    PlotAxes axes = make_axes(m.capture.ray, m.curve, state.plot, outside, true);
    if (m.light && state.viewpoint == Viewpoint::opaque_casters && axes.quantity == Quantity::absorbance)
        axes.value_name = "share of the filter region in front of z, linear";
    beside_curves_ = low.y - corner.y - (fits ? legend : 0) + extent.y - (axes.area.high.y - axes.area.low.y);
    ui.widget_rects["plot"] = axes.area;
    ui.widget_rects["plot.depth_axis"] = {{axes.area.low.x, axes.area.high.y},
                                          {axes.area.high.x, outside.high.y}};
    ui.widget_rects["plot.value_axis"] = {{outside.low.x, axes.area.low.y},
                                          {axes.area.low.x, axes.area.high.y}};
    handle_mouse(axes, m, state);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(outside.low, outside.high, true);
    list.AddRectFilled(axes.area.low, axes.area.high, ui.colors.plot_background);
    draw_axes(list, axes, ui.colors, true);
    list.PushClipRect(axes.area.low, axes.area.high, true);
    draw_layers(list, axes, ui.colors, {m, state, hovered});
    list.PopClipRect();
    if (m.capture.ray.fragments.empty()) {
        draw_text(list,
                  {0.5f * (axes.area.low.x + axes.area.high.x), 0.5f * (axes.area.low.y + axes.area.high.y)},
                  {0.5f, 0.5f}, empty_ray_text(m), ui.colors.text);
        ui.widget_rects["plot.empty"] = axes.area;
    }
    list.PopClipRect();
    if (ImGui::IsItemHovered() && contains(axes.area, ImGui::GetIO().MousePos) && grip_ != Grip::pan)
        draw_crosshair(ui, axes, m, state);
    ImGui::PopID();
    ImGui::EndGroup();
}

}  // namespace momentscope::ui
