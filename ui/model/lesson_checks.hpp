// lesson_checks.hpp -- reads the checks of a step.
#pragma once
#include "ui/model/lesson.hpp"

namespace momentscope::ui {

/// The checks in a value: none if it is null, one of an object, or those of a list. where: begins messages.
/// Throws Error that says what is wrong.
std::vector<Check> checks_from(const nlohmann::json* value, const std::string& where);

}  // namespace momentscope::ui
