// commands.hpp -- the one registry of what a user can do by name: menus, shortcuts, the palette, the key list
// and its tests follow from it.
#pragma once
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/shortcut.hpp"

namespace momentscope::ui {

class Explorer;

struct Command {
    std::string id;                      // as "edit.undo"; what stands before the dot is its menu
    std::string name;                    // as the menu shows it
    std::vector<std::string> keys;       // shortcuts by name, the first is shown; empty when there is none
    std::string help;                    // one sentence
    std::function<void(Explorer&)> run;  // empty: a key that acts while it is held
    std::function<bool(const Explorer&)> enabled{};  // empty: always
    std::function<bool(const Explorer&)> checked{};  // empty: it is no switch
};

/// All commands, menu by menu. ids are unique, and so are keys.
std::span<const Command> commands();

/// The command of that id, which must exist.
const Command& require_command(std::string_view id);

/// The menus in their order: the part of ids before the dot, and its title.
struct Menu {
    const char* id;
    const char* title;
};
std::span<const Menu> menus();

/// What the mouse does, for the key list.
struct MouseAction {
    const char* where;
    const char* how;
    const char* what;
};
std::span<const MouseAction> mouse_actions();

/// May it run now?
bool is_enabled(const Command& command, const Explorer& explorer);

/// Runs the commands whose keys were pressed in this frame.
void run_pressed_commands(Explorer& explorer);

}  // namespace momentscope::ui
