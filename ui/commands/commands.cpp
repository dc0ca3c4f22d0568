#include "ui/commands/commands.hpp"

#include <imgui.h>

#include <algorithm>
#include <cassert>

#include "ui/commands/command_list.hpp"
#include "ui/workspace/workspace.hpp"

namespace momentscope::ui {

namespace {

constexpr Menu MENUS[] = {
    {"file", "File"},       {"edit", "Edit"}, {"view", "View"},           {"pixel", "Pixel"},
    {"compare", "Compare"}, {"plot", "Plot"}, {"technique", "Technique"}, {"scene", "Scene"},
    {"try", "Lessons"},     {"help", "Help"}};

constexpr MouseAction MOUSE_ACTIONS[] = {
    {"scene", "left click or drag", "picks a pixel"},
    {"scene", "right drag", "orbits"},
    {"scene", "middle drag", "pans"},
    {"scene", "wheel", "zooms"},
    {"scene", "Shift+left drag", "measures a region in the Compare tab; a click forgets it"},
    {"scene", "Ctrl+wheel", "zooms the lens: fewer and larger pixels, or more and smaller ones"},
    {"line of the wipe", "drag", "moves the line"},
    {"plot", "left click or drag", "moves the query depth; a click on a step marks its fragment"},
    {"plot", "right or middle drag", "pans"},
    {"plot", "wheel", "zooms at the mouse"},
    {"an axis of the plot", "wheel or drag", "zooms or pans only that axis"},
    {"plot", "double-click", "fits the plot; on an axis, only that axis"},
    {"legend", "click, hover", "a click shows or hides a series; hovering highlights it"},
    {"slider", "Ctrl+click", "lets you type a value"},
    {"slider", "double-click", "resets the value"},
    {"table row", "click", "marks the fragment in the plot"},
    {"window", "drop of a file", "opens a session, a view ray, a lesson or a mesh"}};

}  // namespace

std::span<const Command> commands() {
    static const std::vector<Command> list = make_command_list();
    return list;
}

const Command& require_command(std::string_view id) {
    const auto all = commands();
    const auto found = std::ranges::find(all, id, &Command::id);
    assert(found != all.end() && "a command of that id");
    return *found;
}

std::span<const Menu> menus() {
    return MENUS;
}

std::span<const MouseAction> mouse_actions() {
    return MOUSE_ACTIONS;
}

bool is_enabled(const Command& command, const Workspace& workspace) {
    return !command.enabled || command.enabled(workspace);
}

void run_pressed_commands(Workspace& workspace) {
    // A dialog takes all keys except Escape and the key of the palette.
    const bool dialog = workspace.files.is_open() || workspace.palette.open || workspace.scene.is_reading();
    const bool typing = ImGui::GetIO().WantTextInput;  // Ctrl+Z then edits the text
    for (const Command& command : commands()) {
        if (!command.run || !is_enabled(command, workspace)) continue;
        if (dialog && command.id != "help.close" && command.id != "help.palette") continue;
        if (typing && command.id.starts_with("edit.")) continue;
        const bool repeats = command.id.starts_with("pixel.") || command.id.starts_with("edit.");
        for (const std::string& key : command.keys)
            if (const auto shortcut = parse_shortcut(key); shortcut && pressed(*shortcut, repeats)) {
                command.run(workspace);
                break;
            }
    }
}

}  // namespace momentscope::ui
