// command_list.hpp -- builds the rows of the registry of commands.
#pragma once
#include "ui/commands/commands.hpp"

namespace momentscope::ui {

/// Builds all rows, menu by menu.
std::vector<Command> make_command_list();

}  // namespace momentscope::ui
