// parameter_controls.hpp -- draws one control for each row of the registry of parameters.
#pragma once
#include <optional>
#include <string>

#include "core/techniques/technique.hpp"
#include "ui/model/status.hpp"
#include "ui/widgets/ui.hpp"

namespace momentscope::ui {

/// Draws the control of a parameter: a slider, which also takes typed values, a tooltip, and `auto` if the
/// parameter has it. A double-click on the name or the slider resets the value. The technique defines the
/// meaning of `auto`, unless `automatic` is given, and which choices make no sense with the other values;
/// those are greyed out. `type_now` opens the control as a text field. If a value is refused, `status`
/// explains why.
void draw_parameter_control(const Ui& ui, const Parameter& row, const Technique& technique, float label_width,
                            bool type_now, ParameterValues& values, Status& status,
                            std::optional<float> automatic = {});

/// The text of the tooltip: meaning, option, range, default and source.
std::string parameter_help(const Parameter& row);

}  // namespace momentscope::ui
