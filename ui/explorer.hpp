// explorer.hpp -- the window's content: scene, plot and controls over one state.
#pragma once
#include <imgui.h>

#include <optional>
#include <string>

#include "core/inspect/curve.hpp"
#include "core/render/renderer.hpp"

namespace momentscope::ui {

/// All that the user chose. Everything shown follows from it.
struct ExplorerState {
    std::string scene;           // registry id or path of a mesh file
    std::optional<ViewRay> ray;  // a ray from a file; then its plot is shown without a scene
    const Technique* technique = nullptr;
    ParameterValues parameters;
    std::optional<Camera> camera;  // nullopt: the scene's own
    std::optional<glm::vec2>
        picked;  // fraction of the picture from its upper left corner; nullopt: the scene's own
};

/// What was computed for the state that was shown last.
struct ExplorerResult {
    PixelCapture capture;  // the picked pixel; its transmittance is of the moment it was picked
    Curve curve;           // as the plot draws it
    glm::ivec2 pixel{0};
    glm::ivec2 picture_size{0};
};

/// Draws one ImGui frame after another. Needs a current GL context through the renderer, and an ImGui frame
/// begun.
class Explorer {
public:
    Explorer(Renderer& renderer, ExplorerState state);

    /// Fills the whole ImGui viewport. Recomputes what the state's changes made stale. Failures become the
    /// message line; the last good picture stays.
    void frame();

    const ExplorerState& state() const { return state_; }
    ExplorerState& state() { return state_; }
    const ExplorerResult& result() const { return result_; }
    const std::string& message() const { return message_; }

    /// Where the scene and the plot were drawn last, for tests that point at them.
    ImVec2 scene_corner() const { return scene_corner_; }

private:
    void load_scene_if_changed();
    void apply_opacity();
    void update(glm::ivec2 size);
    void update_ray();
    void update_picture(glm::ivec2 size);
    void update_curve();
    glm::ivec2 picked(glm::ivec2 size) const;
    void draw_scene(ImVec2 size);
    void draw_mark();
    void handle_scene_input();
    void draw_controls();
    void draw_status();

    Renderer& renderer_;
    ExplorerState state_;
    ExplorerResult result_;
    std::string message_;

    Scene scene_;      // what the renderer holds
    View shown_view_;  // technique is null when nothing is shown
    ImVec2 scene_corner_{0, 0};
};

}  // namespace momentscope::ui
