// command_palette.hpp -- finds commands by typed words, and shows the list of all keys.
#pragma once
#include <string>

#include "ui/commands.hpp"
#include "ui/ui.hpp"

namespace momentscope::ui {

class CommandPalette {
public:
    void toggle();
    bool is_open() const { return open_; }
    void close() { open_ = false; }

    /// Draws the palette if it is open. Returns the chosen command in the frame in which it was chosen.
    const Command* draw(const Ui& ui, const Explorer& explorer);

private:
    bool draw_typed(const Ui& ui);

    bool open_ = false;
    bool begin_ = false;
    std::string typed_;
    int chosen_ = 0;
};

/// Does every typed word occur in the command's menu, name or help? Case does not matter.
bool matches(const Command& command, const std::string& typed);

/// Draws all keys and mouse actions in a window. Closing the window clears `open`.
void draw_help(const Ui& ui, bool& open);

}  // namespace momentscope::ui
