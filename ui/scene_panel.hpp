// scene_panel.hpp -- the picture with its tools, marks, lens and mouse handling.
#pragma once
#include <string>

#include "core/render/failure_marks.hpp"
#include "ui/comparison.hpp"
#include "ui/measurement.hpp"
#include "ui/pixel_lens.hpp"
#include "ui/scene_comparison.hpp"
#include "ui/ui.hpp"

namespace momentscope::ui {

/// What the panel shows besides the state. Textures are GL names of the picture's size.
struct ScenePicture {
    unsigned texture = 0;
    unsigned overlay = 0;               // the failures, or 0
    unsigned beside = 0;                // the reference on its side of a wipe, or 0
    std::optional<ColorLegend> legend;  // legend of the false colours that replace the picture
    std::optional<FailureCounts> failures;
    std::string title;  // text in the corner, such as "reference: ..."; may be empty
    Lens lens;
    Camera scene_camera;  // the scene's own
};

class ScenePanel {
public:
    /// Draws the tools and reserves space for the picture. The mouse and the controls change `state`. Returns
    /// the picture's size in pixels; the caller computes a picture of this size, and draw_picture draws it.
    glm::ivec2 draw_controls(const Ui& ui, const Measurement& measurement, const ScenePicture& picture,
                             ExplorerState& state, ImVec2 size, std::string& message);

    void draw_picture(const Ui& ui, const Measurement& measurement, const ScenePicture& picture,
                      const ExplorerState& state) const;

    /// Is the button held that flips to the reference?
    bool flip_held() const { return flip_held_; }

    /// Moves the keyboard focus to the go-to box in the next frame.
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

/// The middle of a pixel as a fraction of the picture. The pixel is first clamped to the picture.
glm::vec2 fraction_of(glm::ivec2 pixel, glm::ivec2 size);

/// The picked pixel in a picture of this size.
glm::ivec2 pixel_of(const std::optional<glm::vec2>& fraction, const Scene& scene, glm::ivec2 size);

/// Picks a pixel and removes the mark of the previous ray.
void pick(ExplorerState& state, glm::vec2 fraction);

}  // namespace momentscope::ui
