// command_rows.hpp -- helpers to write rows of the registry of commands.
#pragma once
#include <utility>

#include "ui/commands/commands.hpp"
#include "ui/workspace/workspace.hpp"

namespace momentscope::ui {

using List = std::vector<Command>;
using Keys = std::vector<std::string>;

inline bool has_picture(const Workspace& w) {
    return !w.state.ray;
}

/// A command that can always run and is not a switch.
inline Command plain(const char* id, const char* name, Keys keys, const char* help,
                     std::function<void(Workspace&)> run) {
    return {id, name, std::move(keys), help, std::move(run)};
}

/// One of several choices. It is checked if `chosen` returns true.
inline Command choice(std::string id, std::string name, Keys keys, std::string help,
                      std::function<void(Workspace&)> choose, std::function<bool(const Workspace&)> chosen) {
    return {std::move(id),    std::move(name), std::move(keys), std::move(help), std::move(choose), {},
            std::move(chosen)};
}

/// A command for the scene's picture. It is disabled for a view ray without a scene.
inline Command of_picture(std::string id, std::string name, Keys keys, std::string help,
                          std::function<void(Workspace&)> run) {
    return {std::move(id), std::move(name), std::move(keys), std::move(help), std::move(run), has_picture};
}

// Menus that have a file of their own (command_list_plot.cpp).
void add_compare(List& list);
void add_plot(List& list);

}  // namespace momentscope::ui
