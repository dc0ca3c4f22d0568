// gui_session.hpp -- an ImGui context that draws with OpenGL, in a window or headless.
#pragma once
#include <glm/glm.hpp>
#include <vector>

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

private:
    static void on_key(GLFWwindow* window, int key, int scancode, int action, int modifiers);
    void release_keys();

    GLFWwindow* window_;
    // ImGui 1.86 looks at the keyboard once per frame and would miss what goes down and up within one. So
    // once a key went down, none goes up before the frame has seen it, nor do the modifiers that belong to
    // it.
    struct Release {
        int key, scancode, modifiers;
    };
    bool pressed_ = false;
    std::vector<Release> releases_;
};

}  // namespace momentscope
