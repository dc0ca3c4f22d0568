// plot_axes.hpp -- from depth and absorbance to the screen and back.
#pragma once
#include "ui/measurement.hpp"
#include "ui/ui.hpp"

namespace momentscope::ui {

/// The plot's area and what its edges mean.
struct PlotAxes {
    Rect area;    // within the axes
    Range depth;  // in the axis's own unit
    Range value;  // absorbance or transmittance
    Quantity quantity = Quantity::absorbance;
    DepthAxis axis = DepthAxis::warped;
    DepthWarp warp;
    const char* value_name = nullptr;  // instead of that of the quantity

    float x_of(float axis_value) const {
        return area.low.x + (axis_value - depth.low) / (depth.high - depth.low) * (area.high.x - area.low.x);
    }
    float y_of(float axis_value) const {
        return area.high.y - (axis_value - value.low) / (value.high - value.low) * (area.high.y - area.low.y);
    }
    float depth_at(float x) const {  // in the axis's own unit
        return depth.low + (x - area.low.x) / (area.high.x - area.low.x) * (depth.high - depth.low);
    }
    float value_at(float y) const {
        return value.low + (area.high.y - y) / (area.high.y - area.low.y) * (value.high - value.low);
    }

    float axis_of(float warped_depth) const;  // warped depth to the axis's own unit
    float warped_of(float axis_value) const;  // and back
    float shown(float absorbance) const;      // absorbance to what the vertical axis shows
    float x(float warped_depth) const { return x_of(axis_of(warped_depth)); }
    float y(float absorbance) const { return y_of(shown(absorbance)); }
    ImVec2 point(float warped_depth, float absorbance) const { return {x(warped_depth), y(absorbance)}; }
};

/// Axes within a rectangle: what the state chose, or what fits the measurement. `labels`: leave room for
/// them?
PlotAxes make_axes(const ViewRay& ray, const Curve& curve, const PlotState& plot, const Rect& outside,
                   bool labels);

/// Grid, ticks and names of the axes.
void draw_axes(ImDrawList& list, const PlotAxes& axes, const Palette& colors, bool labels);

/// The middle of text is at `at` for anchor (.5, .5), its upper left corner for (0, 0).
void draw_text(ImDrawList& list, ImVec2 at, ImVec2 anchor, const std::string& text, ImU32 tint);

}  // namespace momentscope::ui
