// parameter_controls.hpp -- one control per row of the registry of parameters.
#pragma once
#include <optional>
#include <string>

#include "core/techniques/technique.hpp"
#include "ui/ui.hpp"

namespace momentscope::ui {

/// Draws the control of a parameter: slider with typed values, tooltip, `auto` where there is one.
/// Double-clicking the name or the slider resets it. The technique says what auto means, and which choices
/// make no sense beside the other values: these are grey. `type_now` opens it as a text field. A value that
/// was refused is explained in `message`. `automatic` is what auto means where the technique does not say.
void draw_parameter_control(const Ui& ui, const Parameter& row, const Technique& technique, float label_width,
                            bool type_now, ParameterValues& values, std::string& message,
                            std::optional<float> automatic = {});

/// What the tooltip says: meaning, option, range, standard and source.
std::string parameter_help(const Parameter& row);

}  // namespace momentscope::ui
