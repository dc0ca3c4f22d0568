#include "ui/plot/plot_tools.hpp"

#include <algorithm>

#include "ui/model/selection.hpp"

namespace momentscope::ui {

namespace {

// The choice of absorbance or transmittance, and of warped or view depth. Buttons flow to the next line at
// `right`.
void draw_axis_choices(const Ui& ui, bool warped, PlotState& plot, float right) {
    // Returns true if another choice was clicked.
    const auto choose = [&](const char* label, bool on, const char* anchor, const char* help,
                            const char* key) {
        const bool clicked = toggle_button(label, on);
        ui.record_widget_rect(anchor);
        tooltip(help, key);
        return clicked && !on;
    };
    const auto next = [&](const char* label, float gap) { flow(button_width(label), right, gap * em()); };
    if (choose("A", plot.quantity == Quantity::absorbance, "plot.absorbance", "Shows absorbance A(z).", "T"))
        set_quantity(plot, Quantity::absorbance);
    next("T", 0.2f);
    if (choose("T", plot.quantity == Quantity::transmittance, "plot.transmittance",
               "Shows transmittance T(z) = exp(−A(z)).", "T"))
        set_quantity(plot, Quantity::transmittance);
    next("warped", 1);
    if (choose("warped", plot.axis == DepthAxis::warped, "plot.warped",
               "Warped depth, on which the moments are defined (Section 3.3).", "D"))
        set_depth_axis(plot, DepthAxis::warped);
    next("view", 0.2f);
    ImGui::BeginDisabled(!warped);
    if (choose("view", plot.axis == DepthAxis::view, "plot.view",
               warped ? "View depth: the distance from the camera's plane in scene units."
                      : "This ray has no depth warp, so both depths are the same.",
               "D"))
        set_depth_axis(plot, DepthAxis::view);
    ImGui::EndDisabled();
}

// The choice of the ray: from the eye or from the light.
void draw_viewpoint_choice(const Ui& ui, ExplorerState& state, float right) {
    if (state.ray) return;  // the ray has no scene
    const Viewpoint shown = seen_from_light(state) ? state.viewpoint : Viewpoint::eye;
    const struct {
        Viewpoint viewpoint;
        const char *label, *anchor, *help;
    } choices[] = {
        {Viewpoint::eye, "eye", "plot.eye", "The ray from the eye through the picked pixel."},
        {Viewpoint::transparent_casters, "light", "plot.light",
         "What the light's map of transparent casters stores about the surface in the picked pixel, or about the marked "
         "fragment: the mixture of all texels of the filter. Turns shadows on."},
        {Viewpoint::opaque_casters, "opaque", "plot.opaque",
         "The same for the map of opaque casters. A(z) is the share of the filter region in front of z, the moments are those of "
         "four-moment shadow mapping with β = 0, and the sharp bounds are its Hausdorff variant."}};
    for (const auto& choice : choices) {
        if (toggle_button(choice.label, shown == choice.viewpoint)) set_viewpoint(state, choice.viewpoint);
        ui.record_widget_rect(choice.anchor);
        tooltip(choice.help, choice.viewpoint == Viewpoint::opaque_casters ? "" : "V");
        flow(button_width("opaque"), right,
             (choice.viewpoint == Viewpoint::opaque_casters ? 1.0f : 0.2f) * em());
    }
}

}  // namespace

void draw_plot_tools(const Ui& ui, const Measurement& m, ExplorerState& state, float right) {
    PlotState& plot = state.plot;
    draw_viewpoint_choice(ui, state, right);
    draw_axis_choices(ui, m.capture.ray.warp.has_view_depths(), plot, right);
    flow(button_width("fit"), right, em());
    if (ImGui::Button("fit")) fit(plot);
    ui.record_widget_rect("plot.fit");
    tooltip("Fits the plot to the ray.", "F, or double-click in the plot");
    flow(9 * em(), right, em());
    ImGui::SetNextItemWidth(std::min(9 * em(), std::max(right - ImGui::GetCursorScreenPos().x, 20.0f)));
    float query = query_depth(m, state);
    if (ImGui::SliderFloat("##query", &query, -1, 1, "query z = %.3f", ImGuiSliderFlags_AlwaysClamp))
        plot.query = query;
    ui.record_widget_rect("plot.query");
    tooltip(
        "The query depth z, at which the bounds, β and the canonical representation are drawn. Drag in the plot, "
        "or Ctrl+click here to type a number.");
}

}  // namespace momentscope::ui
