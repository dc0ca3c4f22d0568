// parts.hpp -- the parts of the window from top to bottom.
#pragma once
#include "ui/workspace/workspace.hpp"

namespace momentscope::ui {

void draw_menu_bar(const Ui& ui, Workspace& workspace);

/// The sizes in pixels of what lies below the lessons: scene and plot side by side, or one above the other in
/// a high and narrow window.
struct WorkArea {
    ImVec2 size;
    ImVec2 scene;  // the part of the scene
    ImVec2 rest;   // that of plot and tabs
    float bar;     // width of the bars that divide the space
    bool stacked;
    glm::ivec2 picture;
};

/// Is the window too narrow for two parts side by side?
bool is_narrow();

/// Draws only a part of the window, for pages that embed it, and updates the content first.
void draw_embedded(const Ui& ui, Workspace& workspace);

/// Draws the open card and the tools above the picture, and handles the mouse over it. Both change the state.
WorkArea draw_scene_controls(const Ui& ui, Workspace& workspace);

/// The picture, the plot, the pinned plots and the tabs. Call it directly after draw_scene_controls, which
/// left the place of the picture.
void draw_work_area(const Ui& ui, Workspace& workspace, const WorkArea& area);

void draw_status_line(const Ui& ui, Workspace& workspace);

}  // namespace momentscope::ui
