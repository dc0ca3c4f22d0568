#include "ui/window/input_queue.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace momentscope::ui {

struct InputQueue::Frame {
    bool changed = false;  // a button, a key or the focus changed
    bool wheeled = false, typed = false;
};

// Returns false if the frame cannot take the event. A click and a turn of the wheel belong to the mouse
// position at that time, a release to a press that ImGui saw, and a key to the modifiers that were down with
// it.
bool InputQueue::play(const Event& event, ImGuiIO& io, Frame& frame) {
    const bool begun = frame.changed || frame.wheeled || frame.typed;
    if (const auto* move = std::get_if<Move>(&event)) {
        if (begun) return false;
        mouse_ = move->to;
    } else if (const auto* wheel = std::get_if<Wheel>(&event)) {
        if (frame.changed || frame.typed) return false;
        io.MouseWheelH += wheel->notches.x;
        io.MouseWheel += wheel->notches.y;
        frame.wheeled = true;
    } else if (const auto* character = std::get_if<Character>(&event)) {
        if (frame.wheeled) return false;
        io.AddInputCharacter(character->code);
        frame.typed = true;
    } else if (begun) {
        return false;
    } else if (const auto* button = std::get_if<Button>(&event)) {
        if (button->which >= 0 && button->which < ImGuiMouseButton_COUNT)
            down_[static_cast<std::size_t>(button->which)] = button->down;
        frame.changed = true;
    } else if (const auto* key = std::get_if<Key>(&event)) {
        if (key->number >= 0 && key->number < IM_ARRAYSIZE(io.KeysDown)) io.KeysDown[key->number] = key->down;
        io.KeyCtrl = io.KeysDown[GLFW_KEY_LEFT_CONTROL] || io.KeysDown[GLFW_KEY_RIGHT_CONTROL];
        io.KeyShift = io.KeysDown[GLFW_KEY_LEFT_SHIFT] || io.KeysDown[GLFW_KEY_RIGHT_SHIFT];
        io.KeyAlt = io.KeysDown[GLFW_KEY_LEFT_ALT] || io.KeysDown[GLFW_KEY_RIGHT_ALT];
        io.KeySuper = io.KeysDown[GLFW_KEY_LEFT_SUPER] || io.KeysDown[GLFW_KEY_RIGHT_SUPER];
        frame.changed = true;
    } else {
        io.AddFocusEvent(std::get<Focus>(event).here);
        frame.changed = true;
    }
    return true;
}

void InputQueue::begin_frame(ImGuiIO& io) {
    Frame frame;
    while (!waiting_.empty() && play(waiting_.front(), io, frame)) waiting_.pop_front();
    io.MousePos = mouse_;
    std::ranges::copy(down_, io.MouseDown);
}

}  // namespace momentscope::ui
