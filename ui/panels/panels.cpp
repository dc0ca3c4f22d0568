#include "ui/panels/panels.hpp"

namespace momentscope::ui {

void draw_open_panel(const Ui& ui, Workspace& workspace) {
    constexpr std::array DRAW = {
#define PANEL(id, name, help) draw_##id##_panel,
#include "ui/model/panels.def"
#undef PANEL
    };
    DRAW[static_cast<std::size_t>(workspace.state.panel)](ui, workspace);
}

}  // namespace momentscope::ui
