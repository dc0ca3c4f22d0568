// plot_axes.hpp -- maps depth and absorbance to the screen and back.
#pragma once
#include "ui/model/measurement.hpp"
#include "ui/widgets/ui.hpp"

namespace momentscope::ui {

/// The area of the plot and the values at its edges.
struct PlotAxes {
    Rect area;    // inside the axes
    Range depth;  // in the unit of the axis
    Range value;  // of absorbance or transmittance
    Quantity quantity = Quantity::absorbance;
    DepthAxis axis = DepthAxis::warped;
    DepthWarp warp;
    const char* value_name = nullptr;  // overrides the name of the quantity

    float x_of(float axis_value) const {
        return area.low.x + (axis_value - depth.low) / (depth.high - depth.low) * (area.high.x - area.low.x);
    }
    float y_of(float axis_value) const {
        return area.high.y - (axis_value - value.low) / (value.high - value.low) * (area.high.y - area.low.y);
    }
    float depth_at(float x) const {  // in the unit of the axis
        return depth.low + (x - area.low.x) / (area.high.x - area.low.x) * (depth.high - depth.low);
    }
    float value_at(float y) const {
        return value.low + (area.high.y - y) / (area.high.y - area.low.y) * (value.high - value.low);
    }

    float axis_of(float warped_depth) const;  // from warped depth to the unit of the axis
    float warped_of(float axis_value) const;  // and back
    float shown(float absorbance) const;      // from absorbance to the quantity of the vertical axis
    float x(float warped_depth) const { return x_of(axis_of(warped_depth)); }
    float y(float absorbance) const { return y_of(shown(absorbance)); }
    ImVec2 point(float warped_depth, float absorbance) const { return {x(warped_depth), y(absorbance)}; }
};

/// The axes in a rectangle: as the state sets them, or fitted to the measurement. `labels`: leave space for
/// labels?
PlotAxes make_axes(const ViewRay& ray, const Curve& curve, const PlotState& plot, const Rect& outside,
                   bool labels);

/// Draws the grid, the ticks and the names of the axes.
void draw_axes(ImDrawList& list, const PlotAxes& axes, const Palette& colors, bool labels);

/// Draws text with its middle at `at` for anchor (0.5, 0.5), and with its upper left corner there for (0, 0).
void draw_text(ImDrawList& list, ImVec2 at, ImVec2 anchor, const std::string& text, ImU32 tint);

}  // namespace momentscope::ui
