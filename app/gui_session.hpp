// gui_session.hpp -- an ImGui context that draws with OpenGL, in a window or headless.
#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <memory>

#include "app/last_frame.hpp"
#include "app/window_input.hpp"

struct GLFWwindow;

namespace momentscope {

/// Owns the ImGui context of the current GL context. With a window, input comes from the window; otherwise
/// the caller writes it to ImGui::GetIO().
class GuiSession {
public:
    GuiSession(GLFWwindow* window, float ui_scale);
    ~GuiSession();
    GuiSession(const GuiSession&) = delete;
    GuiSession& operator=(const GuiSession&) = delete;

    /// Loads the fonts in another size. Call it between two frames.
    static void set_scale(float ui_scale);

    /// size: of the default framebuffer in pixels. seconds: since the last frame; a window measures this
    /// itself.
    void begin_frame(glm::ivec2 size, float seconds = 1.0f / 60);
    void end_frame(glm::ivec2 size);

    /// The same in two steps, because a frame that nobody looks at need not be painted.
    static void end_frame();
    void paint(glm::ivec2 size) const;

    /// Shows the window's last frame again with a drawing over it. Call it between begin_frame and end_frame.
    void paint_over_last(glm::ivec2 size, const std::function<void(ImDrawList&)>& draw) const;

    /// The events of the window; null without a window.
    WindowInput* input() const { return input_.get(); }

private:
    GLFWwindow* window_;
    std::unique_ptr<WindowInput> input_;
    LastFrame last_;
};

}  // namespace momentscope
