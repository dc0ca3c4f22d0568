// side_panels.hpp -- the tabs below the plot: controls, the pixel's fragments, the technique's properties.
#pragma once
#include <optional>
#include <string>

#include "ui/measurement.hpp"
#include "ui/ui.hpp"

namespace momentscope::ui {

/// Scene, technique, compared techniques and one control per parameter of the registry. `to_type`: the
/// parameter whose control becomes a text field now; taken. Techniques that the GL cannot draw are greyed.
void draw_control_panel(const Ui& ui, OrderedAccess access, ExplorerState& state,
                        std::optional<ParameterId>& to_type, std::string& message);

/// How pictures are drawn and shown, whatever the technique.
void draw_picture_controls(const Ui& ui, ExplorerState& state, std::string& message);

/// Whether there are shadows, and how they are made. `light` and `distance` are the scene's own.
void draw_shadow_controls(const Ui& ui, const Light& light, float distance, ExplorerState& state,
                          std::string& message);

/// The pixel's history: one row per fragment from front to back. Clicking a row marks it in the plot.
void draw_fragment_panel(const Ui& ui, const Measurement& measurement, ExplorerState& state);

/// What the technique is, what it costs and where it comes from.
void draw_technique_panel(const Ui& ui, const Measurement& measurement, const ExplorerState& state);

}  // namespace momentscope::ui
