// gui_session.hpp -- an ImGui context that draws with OpenGL, in a window or headless.
#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <memory>

#include "app/last_frame.hpp"
#include "app/window_input.hpp"

struct GLFWwindow;

namespace momentscope {

/// Owns the ImGui context of the current GL context. With a window it takes input from there; without, input
/// is what the caller writes to ImGui::GetIO().
class GuiSession {
public:
    GuiSession(GLFWwindow* window, float ui_scale);
    ~GuiSession();
    GuiSession(const GuiSession&) = delete;
    GuiSession& operator=(const GuiSession&) = delete;

    /// size: of the default framebuffer in pixels. seconds: since the last frame; a window measures by
    /// itself.
    void begin_frame(glm::ivec2 size, float seconds = 1.0f / 60);
    void end_frame(glm::ivec2 size);

    /// The same in two steps: a frame that nobody looks at need not be painted.
    static void end_frame();
    void paint(glm::ivec2 size) const;

    /// Shows the window's last frame again with something drawn over it, between begin_frame and end_frame.
    void paint_over_last(glm::ivec2 size, const std::function<void(ImDrawList&)>& draw) const;

    /// The window's events; null without a window.
    WindowInput* input() const { return input_.get(); }

private:
    GLFWwindow* window_;
    std::unique_ptr<WindowInput> input_;
    LastFrame last_;
};

}  // namespace momentscope
