// scene_panel.hpp -- the picture with its tools, marks, lens and mouse handling.
#pragma once
#include "ui/model/measurement.hpp"
#include "ui/picture/scene_picture.hpp"
#include "ui/widgets/ui.hpp"

namespace momentscope::ui {

class ScenePanel {
public:
    /// Draws the tools, if they are wanted, and takes the mouse in the place of the picture, both of which
    /// change `state`. Returns the picture's size in pixels. The caller computes a picture of this size, and
    /// draw_picture draws it.
    glm::ivec2 draw_controls(const Ui& ui, const Measurement& measurement, const ScenePicture& picture,
                             ExplorerState& state, ImVec2 size, bool tools, Status& status);

    /// Draws the picture into the place that draw_controls left for it.
    void draw_picture(const Ui& ui, const Measurement& measurement, const ScenePicture& picture,
                      const ExplorerState& state) const;

    /// Is the button held that flips to the reference?
    bool flip_held() const { return flip_held_; }

    /// Moves the keyboard focus to the go-to box in the next frame.
    void focus_go_to() { focus_go_to_ = true; }

private:
    void draw_tools(const Ui& ui, const Measurement& measurement, const ScenePicture& picture,
                    ExplorerState& state, Status& status);
    void draw_go_to(glm::ivec2 size, ExplorerState& state, Status& status);
    void handle_left(const Ui& ui, const Measurement& measurement, const ScenePicture& picture,
                     ExplorerState& state);
    void handle_mouse(const Ui& ui, const Measurement& measurement, const ScenePicture& picture,
                      ExplorerState& state);

    enum class Drag { none, pick, divider, region };

    ImDrawList* list_ = nullptr;  // of the window that draw_controls drew into and left
    bool flip_held_ = false;
    bool focus_go_to_ = false;
    Drag drag_ = Drag::none;  // of the left button
    glm::ivec2 drag_from_{0};
};

}  // namespace momentscope::ui
