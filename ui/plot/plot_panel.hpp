// plot_panel.hpp -- the plot with its tools, legend, mouse handling and notes.
#pragma once
#include <optional>

#include "ui/plot/plot_axes.hpp"

namespace momentscope::ui {

class PlotPanel {
public:
    /// Draws into a rectangle of this size at the cursor. The mouse and the controls change `state`.
    /// Where the legend would leave less than LEAST_PLOT for the curves, a button opens it instead.
    void draw(const Ui& ui, const Measurement& measurement, ExplorerState& state, ImVec2 size);

    static constexpr float LEAST_PLOT = 12;  // font heights

    /// The height that leaves LEAST_PLOT for the curves, as of the last frame.
    float least_height() const { return beside_curves_ + LEAST_PLOT * em(); }

private:
    enum class Grip { none, query, pan };

    void handle_mouse(const PlotAxes& axes, const Measurement& measurement, ExplorerState& state);
    void zoom(const PlotAxes& axes, PlotState& plot, bool depth, bool value, float notches) const;
    void pan(const PlotAxes& axes, PlotState& plot) const;

    Grip grip_ = Grip::none;
    float beside_curves_ = 0;  // the height of all but curves and legend, in the last frame
    std::optional<float> query_before_click_;
    std::optional<std::size_t> marked_before_click_;
    bool grips_depth_ = true;  // whether panning moves the depth axis and the value axis
    bool grips_value_ = true;
};

}  // namespace momentscope::ui
