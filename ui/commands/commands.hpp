// commands.hpp -- the registry of commands. Menus, shortcuts, the palette, the key list and its tests are
// built from it.
#pragma once
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/widgets/shortcut.hpp"

namespace momentscope::ui {

struct Workspace;

struct Command {
    std::string id;                       // such as "edit.undo"; the part before the dot is the menu
    std::string name;                     // the text in the menu
    std::vector<std::string> keys;        // names of shortcuts; the menu shows the first one
    std::string help;                     // one sentence
    std::function<void(Workspace&)> run;  // empty: the key acts while it is held
    std::function<bool(const Workspace&)> enabled{};  // empty: always enabled
    std::function<bool(const Workspace&)> checked{};  // empty: not a switch
};

/// All commands, menu by menu. Ids and keys are unique.
std::span<const Command> commands();

/// The command with this id, which must exist.
const Command& require_command(std::string_view id);

/// The menus in order: the part of command ids before the dot, and the title.
struct Menu {
    const char* id;
    const char* title;
};
std::span<const Menu> menus();

/// A mouse action, for the key list.
struct MouseAction {
    const char* where;
    const char* how;
    const char* what;
};
std::span<const MouseAction> mouse_actions();

/// Can the command run now?
bool is_enabled(const Command& command, const Workspace& workspace);

/// Runs the commands whose keys were pressed in this frame.
void run_pressed_commands(Workspace& workspace);

}  // namespace momentscope::ui
