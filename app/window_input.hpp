// window_input.hpp -- events of a GLFW window: input for ImGui, and whether anything happened at all.
#pragma once
#include <optional>
#include <string>
#include <utility>

#include "ui/window/input_queue.hpp"

struct GLFWwindow;

namespace momentscope {

/// Takes over the window's callbacks and its user pointer. It must outlive the last polling of events.
class WindowInput {
public:
    explicit WindowInput(GLFWwindow* window);
    WindowInput(const WindowInput&) = delete;
    WindowInput& operator=(const WindowInput&) = delete;

    /// Call it before ImGui::NewFrame() and after the backend's NewFrame, which would pass on only the last
    /// state.
    void begin_frame(ImGuiIO& io) { queue_.begin_frame(io); }

    /// Is input waiting for the next frame?
    bool waits() const { return !queue_.empty(); }

    /// The path of a file that was dropped on the window since the last call; the first, if there were
    /// several.
    std::optional<std::string> take_dropped() { return std::exchange(dropped_, std::nullopt); }

    /// Has anything happened since the last call that requires a new frame?
    bool take_happened() { return std::exchange(happened_, false); }

private:
    void push(const ui::InputQueue::Event& event);
    void move_here();

    GLFWwindow* window_;
    ui::InputQueue queue_;
    bool happened_ = false;
    std::optional<std::string> dropped_;
    int held_buttons_ = 0;
};

}  // namespace momentscope
