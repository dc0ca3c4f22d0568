// side_panels.hpp -- the tabs below the plot: controls, the pixel's fragments, the technique's properties.
#pragma once
#include <optional>
#include <string>

#include "ui/measurement.hpp"
#include "ui/ui.hpp"

namespace momentscope::ui {

/// Draws scene, technique, compared techniques and one control per parameter of the registry. `to_type`: the
/// parameter whose control becomes a text field now; it is reset. Techniques that the GL cannot draw are
/// greyed out.
void draw_control_panel(const Ui& ui, OrderedAccess access, ExplorerState& state,
                        std::optional<ParameterId>& to_type, std::string& message);

/// Draws the controls that apply to all techniques.
void draw_picture_controls(const Ui& ui, ExplorerState& state, std::string& message);

/// Draws the controls of shadows. `light` and `distance` are the scene's own.
void draw_shadow_controls(const Ui& ui, const Light& light, float distance, ExplorerState& state,
                          std::string& message);

/// Draws the pixel's history: one row per fragment from front to back. A click on a row marks its fragment in
/// the plot.
void draw_fragment_panel(const Ui& ui, const Measurement& measurement, ExplorerState& state);

/// Draws what the technique does, what it costs and where it was published.
void draw_technique_panel(const Ui& ui, const Measurement& measurement, const ExplorerState& state);

}  // namespace momentscope::ui
