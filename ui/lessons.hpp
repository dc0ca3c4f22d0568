// lessons.hpp -- the "Try this" cards: a state to start from, what is seen there, and a question.
#pragma once
#include <span>
#include <string_view>

#include "ui/state.hpp"

namespace momentscope::ui {

struct Lesson {
    const char* id;
    const char* title;
    const char* text;      // two sentences: what is shown, and what to look at
    const char* question;  // answered by what is shown
    const char* answer;
    void (*prepare)(ExplorerState& state);  // from a fresh state
};

std::span<const Lesson> lessons();
const Lesson* find_lesson(std::string_view id);  // nullptr when there is none

/// A fresh state with the card open; theme and layout stay.
void open_lesson(ExplorerState& state, const Lesson& lesson);

}  // namespace momentscope::ui
