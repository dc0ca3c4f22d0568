#include "ui/panels/panels.hpp"

namespace momentscope::ui {

void draw_stress_panel(const Ui& ui, Workspace& w) {
    w.stress.draw(ui, w.state, w.status);
}

}  // namespace momentscope::ui
