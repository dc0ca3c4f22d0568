// command_palette.hpp -- finds commands by typed words, and shows the list of all keys.
#pragma once
#include <string>

#include "ui/commands/commands.hpp"
#include "ui/widgets/ui.hpp"

namespace momentscope::ui {

/// Draws the palette if it is open. Returns the chosen command in the frame in which it was chosen.
const Command* draw_palette(const Ui& ui, Workspace& workspace);

/// Does every typed word occur in the command's menu, name or help? Case does not matter.
bool matches(const Command& command, const std::string& typed);

/// Draws all keys and mouse actions in a window. Closing the window clears `open`.
void draw_help(const Ui& ui, bool& open);

}  // namespace momentscope::ui
