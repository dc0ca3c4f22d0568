// parameter_controls.hpp -- one control per row of the registry of parameters.
#pragma once
#include "core/techniques/technique.hpp"

namespace momentscope::ui {

/// Draws the controls of the parameters that the technique reads, with tooltips. True when a value changed.
bool draw_parameter_controls(const Technique& technique, ParameterValues& values);

/// Draws one control. `recommended` is what `auto` means.
bool draw_parameter_control(const Parameter& row, float recommended, ParameterValues& values);

}  // namespace momentscope::ui
