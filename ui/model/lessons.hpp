// lessons.hpp -- the "Try this" cards: a state to start from, a description and a question.
#pragma once
#include <span>
#include <string_view>

#include "ui/model/state.hpp"

namespace momentscope::ui {

struct Lesson {
    const char* id;
    const char* title;
    const char* text;      // what is shown, and what to look at
    const char* question;  // the shown state answers it
    const char* answer;
    void (*prepare)(ExplorerState& state);  // changes a fresh state
    bool shows_error = false;               // the card shows the error of the pixel's colour
};

std::span<const Lesson> lessons();
const Lesson* find_lesson(std::string_view id);  // nullptr if there is none

/// Sets a fresh state with the card open. Theme and layout stay.
void open_lesson(ExplorerState& state, const Lesson& lesson);

}  // namespace momentscope::ui
