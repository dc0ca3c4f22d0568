// status.hpp -- what the window says to the user.
#pragma once
#include <optional>
#include <string>
#include <utility>

namespace momentscope::ui {

struct Status {
    std::string message;  // in the status line until the next input; "": none
    std::string warning;  // which parts of the scene are missing; "": none is

    /// A scene that is being read.
    struct Progress {
        std::string what;  // its id or path
        std::string step;
        double seconds = 0;  // since the start
    };
    std::optional<Progress> progress;

    void say(std::string text) { message = std::move(text); }
};

}  // namespace momentscope::ui
