// window_input.hpp -- what happens to a GLFW window: input for ImGui, and whether anything happened at all.
#pragma once
#include <utility>

#include "app/input_queue.hpp"

struct GLFWwindow;

namespace momentscope {

/// Takes the window's callbacks and its user pointer; lives until no more events are asked for.
class WindowInput {
public:
    explicit WindowInput(GLFWwindow* window);
    WindowInput(const WindowInput&) = delete;
    WindowInput& operator=(const WindowInput&) = delete;

    /// Before ImGui::NewFrame(), and after the backend's, which would only know the last state.
    void begin_frame(ImGuiIO& io) { queue_.begin_frame(io); }

    /// Does input wait for the next frame?
    bool waits() const { return !queue_.empty(); }

    /// Did anything happen since it was asked last for which the window must be drawn again?
    bool take_happened() { return std::exchange(happened_, false); }

private:
    void push(const InputQueue::Event& event);
    void move_here();

    GLFWwindow* window_;
    InputQueue queue_;
    bool happened_ = false;
    int held_buttons_ = 0;
};

}  // namespace momentscope
