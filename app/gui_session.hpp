// gui_session.hpp -- an ImGui context that draws with OpenGL, in a window or headless.
#pragma once
#include <glm/glm.hpp>

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

    /// size: of the default framebuffer in pixels. seconds: since the last frame; a window measures by itself.
    void begin_frame(glm::ivec2 size, float seconds = 1.0f / 60);
    void end_frame(glm::ivec2 size);

private:
    GLFWwindow* window_;
};

}  // namespace momentscope
