// scene_panel.hpp -- the picture with its tool row, marks, lens and mouse.
#pragma once
#include <string>

#include "core/image/image.hpp"
#include "ui/measurement.hpp"
#include "ui/ui.hpp"

namespace momentscope::ui {

/// What the panel shows beside the state; textures are GL names of the picture's size.
struct ScenePicture {
    unsigned texture = 0;
    unsigned overlay = 0;  // of failures, or 0
    std::optional<FailureCounts> failures;
    const char* title = "";     // drawn in the corner, as "ground truth"; or empty
    glm::ivec2 lens_corner{0};  // upper left pixel of the lens's region
    Image lens;                 // empty: no lens
    Camera scene_camera;        // the scene's own
};

class ScenePanel {
public:
    /// Draws the tool row and makes room for the picture; the mouse and the controls change `state`. Returns
    /// the picture's size in pixels, for which the picture is then computed, and drawn by draw_picture.
    glm::ivec2 draw_controls(const Ui& ui, const Measurement& measurement, const ScenePicture& picture,
                             ExplorerState& state, ImVec2 size, std::string& message);

    void draw_picture(const Ui& ui, const Measurement& measurement, const ScenePicture& picture,
                      const ExplorerState& state) const;

    /// Is the button that shows the ground truth held down?
    bool truth_held() const { return truth_held_; }

    /// Puts the keyboard into the go-to box in the next frame.
    void focus_go_to() { focus_go_to_ = true; }

private:
    void draw_tools(const Ui& ui, const Measurement& measurement, const ScenePicture& picture,
                    ExplorerState& state, std::string& message);
    void draw_go_to(glm::ivec2 size, ExplorerState& state, std::string& message);
    void handle_mouse(const Measurement& measurement, const ScenePicture& picture,
                      ExplorerState& state) const;

    ImVec2 corner_{0, 0};
    std::string go_to_;
    bool truth_held_ = false;
    bool focus_go_to_ = false;
};

/// How far the lens reaches from its middle, in pixels.
constexpr int LENS_RADIUS = 2;

/// The fraction of the picture at the middle of a pixel, which is first brought within it.
glm::vec2 fraction_of(glm::ivec2 pixel, glm::ivec2 size);

/// The pixel that the state picks in a picture of that size.
glm::ivec2 pixel_of(const std::optional<glm::vec2>& fraction, const Scene& scene, glm::ivec2 size);

/// Picks a pixel; what was marked on the last ray is forgotten.
void pick(ExplorerState& state, glm::vec2 fraction);

}  // namespace momentscope::ui
