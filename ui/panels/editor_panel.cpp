#include "ui/panels/panels.hpp"

namespace momentscope::ui {

void draw_editor_panel(const Ui& ui, Workspace& w) {
    w.editor.draw(ui, w.measurement(), w.state, w.status);
}

}  // namespace momentscope::ui
