// frame_need.hpp -- decides when the window must be drawn: after input, and while the window lags behind the
// state.
#pragma once
#include "ui/window/explorer.hpp"

namespace momentscope::ui {

class FrameNeed {
public:
    /// ImGui needs a few frames for its layout, and until a field that a key opened accepts typed text.
    static constexpr int SETTLING_FRAMES = 5;

    void input() { left_ = SETTLING_FRAMES; }
    void drawn() { left_ = left_ > 0 ? left_ - 1 : 0; }

    /// Are frames still due after the last input?
    bool settling() const { return left_ > 0; }
    bool due(const Explorer& explorer) const { return settling() || wants_frame(explorer.workspace()); }

private:
    int left_ = SETTLING_FRAMES;
};

}  // namespace momentscope::ui
