// step_texts.hpp -- the steps of a reconstruction in words.
#pragma once
#include <string>
#include <vector>

#include "core/inspect/steps.hpp"

namespace momentscope {

/// One step in words for students, with its equation and its numbers.
struct StepText {
    std::string title;
    std::string sentence;
    std::string numbers;  // lines
};
std::vector<StepText> step_texts(const Steps& steps);

/// All steps as text for the terminal.
std::string steps_to_text(const Steps& steps);

}  // namespace momentscope
