// input_queue.hpp -- hands mouse and keyboard events to ImGui frame by frame.
#pragma once
#include <imgui.h>

#include <array>
#include <cfloat>
#include <deque>
#include <variant>

namespace momentscope::ui {

/// ImGui 1.86 looks at mouse and keyboard once per frame and would miss a button that goes down and up
/// between two frames. So events wait here in order, and a frame gets only as many as it can distinguish.
class InputQueue {
public:
    /// In pixels from the upper left corner; OUTSIDE if the mouse left the window.
    struct Move {
        ImVec2 to;
    };
    struct Button {
        int which;  // ImGuiMouseButton_
        bool down;
    };
    struct Wheel {
        ImVec2 notches;
    };
    struct Key {
        int number;  // GLFW's number
        bool down;
    };
    struct Character {
        unsigned code;
    };
    /// Without the focus, no key counts as held.
    struct Focus {
        bool here;
    };
    using Event = std::variant<Move, Button, Wheel, Key, Character, Focus>;
    static inline const ImVec2 OUTSIDE{-FLT_MAX, -FLT_MAX};

    void push(const Event& event) { waiting_.push_back(event); }
    bool empty() const { return waiting_.empty(); }

    /// Updates mouse and keyboard for the following ImGui::NewFrame(). Events that do not fit into the frame
    /// wait for the next one.
    void begin_frame(ImGuiIO& io);

private:
    struct Frame;  // the events of a frame so far
    bool play(const Event& event, ImGuiIO& io, Frame& frame);

    std::deque<Event> waiting_;
    ImVec2 mouse_ = OUTSIDE;
    std::array<bool, ImGuiMouseButton_COUNT> down_{};
};

}  // namespace momentscope::ui
