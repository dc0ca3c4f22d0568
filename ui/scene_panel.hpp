// scene_panel.hpp -- the picture with its tool row, marks, lens and mouse.
#pragma once
#include <string>

#include "ui/comparison.hpp"
#include "ui/measurement.hpp"
#include "ui/pixel_lens.hpp"
#include "ui/scene_comparison.hpp"
#include "ui/ui.hpp"

namespace momentscope::ui {

/// What the panel shows beside the state; textures are GL names of the picture's size.
struct ScenePicture {
    unsigned texture = 0;
    unsigned overlay = 0;               // of failures, or 0
    unsigned beside = 0;                // the reference on its side of a wipe, or 0
    std::optional<ColorLegend> legend;  // of the false colours that are shown in place of the picture
    std::optional<FailureCounts> failures;
    std::string title;  // drawn in the corner, as "reference: ..."; or empty
    Lens lens;
    Camera scene_camera;  // the scene's own
};

class ScenePanel {
public:
    /// Draws the tool row and makes room for the picture; the mouse and the controls change `state`. Returns
    /// the picture's size in pixels, for which the picture is then computed, and drawn by draw_picture.
    glm::ivec2 draw_controls(const Ui& ui, const Measurement& measurement, const ScenePicture& picture,
                             ExplorerState& state, ImVec2 size, std::string& message);

    void draw_picture(const Ui& ui, const Measurement& measurement, const ScenePicture& picture,
                      const ExplorerState& state) const;

    /// Is the button that flips to the reference held down?
    bool flip_held() const { return flip_held_; }

    /// Puts the keyboard into the go-to box in the next frame.
    void focus_go_to() { focus_go_to_ = true; }

private:
    void draw_tools(const Ui& ui, const Measurement& measurement, const ScenePicture& picture,
                    ExplorerState& state, std::string& message);
    void draw_go_to(glm::ivec2 size, ExplorerState& state, std::string& message);
    void handle_left(const Ui& ui, const Measurement& measurement, const ScenePicture& picture,
                     ExplorerState& state);
    void handle_mouse(const Ui& ui, const Measurement& measurement, const ScenePicture& picture,
                      ExplorerState& state);

    enum class Drag { none, pick, divider, region };

    ImVec2 corner_{0, 0};
    bool flip_held_ = false;
    bool focus_go_to_ = false;
    Drag drag_ = Drag::none;  // of the left button
    glm::ivec2 drag_from_{0};
};

/// The fraction of the picture at the middle of a pixel, which is first brought within it.
glm::vec2 fraction_of(glm::ivec2 pixel, glm::ivec2 size);

/// The pixel that the state picks in a picture of that size.
glm::ivec2 pixel_of(const std::optional<glm::vec2>& fraction, const Scene& scene, glm::ivec2 size);

/// Picks a pixel; what was marked on the last ray is forgotten.
void pick(ExplorerState& state, glm::vec2 fraction);

}  // namespace momentscope::ui
