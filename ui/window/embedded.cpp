// embedded.cpp -- a part of the window in a page of somebody else.
#include <algorithm>

#include "ui/panels/panels.hpp"
#include "ui/widgets/parameter_controls.hpp"
#include "ui/window/parts.hpp"
#include "ui/window/update.hpp"

namespace momentscope::ui {

namespace {

constexpr glm::ivec2 UNSEEN_PICTURE(480, 270);  // of a scene of which only the plot or a tab is shown
constexpr float LABEL_WIDTH = 13;               // in em

Pointer pointer() {
    return {ImGui::IsAnyMouseDown(), ImGui::GetIO().DeltaTime};
}

void draw_controls(const Ui& ui, Workspace& w) {
    for (const ParameterId id : w.options.embedding.controls)
        draw_parameter_control(ui, parameter(id), *w.state.technique, LABEL_WIDTH * em(), false,
                               w.state.parameters, w.status);
}

void draw_scene(const Ui& ui, Workspace& w, ImVec2 size) {
    ImGui::BeginChild("scene side", size, false,
                      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    const glm::ivec2 picture =
        w.scene_panel.draw_controls(ui, w.measurement(), w.scene_picture, w.state, size, true, w.status);
    ImGui::EndChild();
    update_window(w, picture, pointer());
    w.scene_panel.draw_picture(ui, w.measurement(), w.scene_picture, w.state);
}

}  // namespace

void draw_embedded(const Ui& ui, Workspace& w) {
    const Embedding& embedding = w.options.embedding;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float below = static_cast<float>(embedding.controls.size()) * ImGui::GetFrameHeightWithSpacing() +
                        (w.status.message.empty() ? 0 : ImGui::GetTextLineHeightWithSpacing());
    const ImVec2 size = {room.x, std::max(room.y - below, 1.0f)};
    if (embedding.shown == Shown::scene) {
        draw_scene(ui, w, size);
    } else {
        update_window(w, UNSEEN_PICTURE, pointer());
        if (w.picked.empty()) return;
        if (embedding.shown == Shown::plot) {
            w.plot_panel.draw(ui, w.measurement(), w.state, size);
        } else {
            w.state.panel = embedding.panel;
            ImGui::BeginChild("panel", size);
            draw_open_panel(ui, w);
            ImGui::EndChild();
        }
    }
    draw_controls(ui, w);
    if (!w.status.message.empty()) draw_status_line(ui, w);
}

}  // namespace momentscope::ui
