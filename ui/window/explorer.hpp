// explorer.hpp -- the content of the window: scene, plot and panels of one state.
#pragma once
#include <optional>

#include "ui/workspace/workspace.hpp"

namespace momentscope::ui {

/// Draws ImGui frames. The GL context of the renderer must be current, and an ImGui frame must have begun.
class Explorer {
public:
    Explorer(Renderer& renderer, ExplorerState state, WindowOptions options = {});

    /// Fills the whole ImGui viewport. First the input changes the state, then what it made stale is
    /// computed, then everything is drawn. Throws Error only if there was no good picture yet.
    void frame();

    /// Is the state a step of the user: shown, and nothing is being dragged or typed?
    bool is_at_a_step() const;

    /// Sets another scale of fonts and spacing. The caller loads the fonts.
    void set_scale(float scale) {
        workspace_.options.scale = scale;
        styled_.reset();
    }

    /// The scale that the user wants now; `own` is that of the screen or of the command line.
    float wanted_scale(float own) const { return own * workspace_.settings.text_scale; }

    /// Draws the word "drawing…" over the last frame while a long picture is drawn. Before the first picture,
    /// fills the window with the names of the program and of the scene.
    void draw_waiting(ImDrawList& list) const;

    Workspace& workspace() { return workspace_; }
    const Workspace& workspace() const { return workspace_; }

private:
    Workspace workspace_;
    std::optional<ThemeKind> styled_;  // the theme that ImGui was set to
};

}  // namespace momentscope::ui
