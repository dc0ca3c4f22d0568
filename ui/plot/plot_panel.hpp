// plot_panel.hpp -- the plot with its tools, legend, mouse handling and notes.
#pragma once
#include <optional>

#include "ui/plot/plot_axes.hpp"

namespace momentscope::ui {

class PlotPanel {
public:
    /// Draws into a rectangle of this size at the cursor. The mouse and the controls change `state`.
    void draw(const Ui& ui, const Measurement& measurement, ExplorerState& state, ImVec2 size);

private:
    enum class Grip { none, query, pan };

    void handle_mouse(const PlotAxes& axes, const Measurement& measurement, ExplorerState& state);
    void zoom(const PlotAxes& axes, PlotState& plot, bool depth, bool value, float notches) const;
    void pan(const PlotAxes& axes, PlotState& plot) const;

    Grip grip_ = Grip::none;
    std::optional<float> query_before_click_;
    std::optional<std::size_t> marked_before_click_;
    bool grips_depth_ = true;  // whether panning moves the depth axis and the value axis
    bool grips_value_ = true;
};

}  // namespace momentscope::ui
