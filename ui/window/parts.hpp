// parts.hpp -- the parts of the window from top to bottom.
#pragma once
#include "ui/workspace/workspace.hpp"

namespace momentscope::ui {

void draw_menu_bar(const Ui& ui, Workspace& workspace);

/// The "Try this" row and the open card.
void draw_lessons(const Ui& ui, Workspace& workspace);

/// The sizes in pixels of what lies side by side below the cards.
struct WorkArea {
    ImVec2 size;
    float left;  // width of the side of the scene
    float bar;   // width of the bars that divide the space
    glm::ivec2 picture;
};

/// Draws the tools above the picture and handles the mouse over it. Both change the state.
WorkArea draw_scene_controls(const Ui& ui, Workspace& workspace);

/// The picture, the plot, the pinned plots and the tabs. Call it directly after draw_scene_controls, which
/// left the place of the picture.
void draw_work_area(const Ui& ui, Workspace& workspace, const WorkArea& area);

void draw_status_line(const Ui& ui, Workspace& workspace);

}  // namespace momentscope::ui
