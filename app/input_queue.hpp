// input_queue.hpp -- what mouse and keyboard did, handed to ImGui frame by frame.
#pragma once
#include <imgui.h>

#include <array>
#include <cfloat>
#include <deque>
#include <variant>

namespace momentscope {

/// ImGui 1.86 looks at mouse and keyboard once per frame and would miss what goes down and up within one. So
/// events wait here in their order, and a frame gets no more of them than it can tell apart.
class InputQueue {
public:
    /// Pixels from the upper left corner; OUTSIDE when the mouse left the window.
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
        int number;  // GLFW's
        bool down;
    };
    struct Character {
        unsigned code;
    };
    /// Without it no key is held.
    struct Focus {
        bool here;
    };
    using Event = std::variant<Move, Button, Wheel, Key, Character, Focus>;
    static inline const ImVec2 OUTSIDE{-FLT_MAX, -FLT_MAX};

    void push(const Event& event) { waiting_.push_back(event); }
    bool empty() const { return waiting_.empty(); }

    /// Brings mouse and keyboard up to date for the ImGui::NewFrame() that follows. What does not fit into
    /// the frame waits for the next one.
    void begin_frame(ImGuiIO& io);

private:
    struct Frame;  // what happened in it so far
    bool play(const Event& event, ImGuiIO& io, Frame& frame);

    std::deque<Event> waiting_;
    ImVec2 mouse_ = OUTSIDE;
    std::array<bool, ImGuiMouseButton_COUNT> down_{};
};

}  // namespace momentscope
