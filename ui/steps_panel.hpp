// steps_panel.hpp -- the tab that shows one reconstruction step by step, following Algorithm 1 or 2.
#pragma once
#include "ui/measurement.hpp"
#include "ui/ui.hpp"

namespace momentscope::ui {

void draw_steps_panel(const Ui& ui, const Measurement& measurement);

}  // namespace momentscope::ui
