#include "app/window_input.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace momentscope {

namespace {

WindowInput& input_of(GLFWwindow* window) {
    return *static_cast<WindowInput*>(glfwGetWindowUserPointer(window));
}

}  // namespace

WindowInput::WindowInput(GLFWwindow* window) : window_(window) {
    glfwSetWindowUserPointer(window, this);
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
        input_of(w).push(ui::InputQueue::Move{{static_cast<float>(x), static_cast<float>(y)}});
    });
    // A drag continues outside the window.
    glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
        if (entered != 0)
            input_of(w).move_here();
        else if (input_of(w).held_buttons_ == 0)
            input_of(w).push(ui::InputQueue::Move{ui::InputQueue::OUTSIDE});
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
        int& held = input_of(w).held_buttons_;
        held = std::max(held + (action == GLFW_PRESS ? 1 : -1), 0);
        input_of(w).push(ui::InputQueue::Button{button, action == GLFW_PRESS});
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
        input_of(w).push(ui::InputQueue::Wheel{{static_cast<float>(x), static_cast<float>(y)}});
    });
    // ImGui repeats keys itself, but it needs frames to do so.
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) {
        if (action == GLFW_REPEAT)
            input_of(w).happened_ = true;
        else
            input_of(w).push(ui::InputQueue::Key{key, action == GLFW_PRESS});
    });
    glfwSetCharCallback(
        window, [](GLFWwindow* w, unsigned code) { input_of(w).push(ui::InputQueue::Character{code}); });
    glfwSetWindowFocusCallback(
        window, [](GLFWwindow* w, int focused) { input_of(w).push(ui::InputQueue::Focus{focused != 0}); });
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
        if (count > 0) input_of(w).dropped_ = paths[0];
        input_of(w).happened_ = true;
    });
    // When the window is uncovered, resized or restored, there is no input, but it must be drawn.
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { input_of(w).happened_ = true; });
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { input_of(w).happened_ = true; });
    glfwSetWindowIconifyCallback(window, [](GLFWwindow* w, int) { input_of(w).happened_ = true; });
    if (glfwGetWindowAttrib(window, GLFW_HOVERED) != 0) move_here();
}

void WindowInput::push(const ui::InputQueue::Event& event) {
    queue_.push(event);
    happened_ = true;
}

void WindowInput::move_here() {
    double x = 0;
    double y = 0;
    glfwGetCursorPos(window_, &x, &y);
    push(ui::InputQueue::Move{{static_cast<float>(x), static_cast<float>(y)}});
}

}  // namespace momentscope
