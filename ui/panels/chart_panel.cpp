#include "ui/panels/panels.hpp"

namespace momentscope::ui {

void draw_chart_panel(const Ui& ui, Workspace& w) {
    if (w.chart.draw(ui, w.scene.scene(), w.state, w.status)) w.files.save_chart();
}

}  // namespace momentscope::ui
