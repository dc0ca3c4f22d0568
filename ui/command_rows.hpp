// command_rows.hpp -- how rows of the registry of commands are written.
#pragma once
#include <utility>

#include "ui/commands.hpp"
#include "ui/explorer.hpp"

namespace momentscope::ui {

using List = std::vector<Command>;
using Keys = std::vector<std::string>;

inline bool has_picture(const Explorer& e) {
    return !e.state().ray;
}

/// A command that may always run and is no switch.
inline Command plain(const char* id, const char* name, Keys keys, const char* help,
                     std::function<void(Explorer&)> run) {
    return {id, name, std::move(keys), help, std::move(run)};
}

/// One of several choices: checked while `chosen` holds.
inline Command choice(std::string id, std::string name, Keys keys, std::string help,
                      std::function<void(Explorer&)> choose, std::function<bool(const Explorer&)> chosen) {
    return {std::move(id),    std::move(name), std::move(keys), std::move(help), std::move(choose), {},
            std::move(chosen)};
}

/// Of the scene's picture, which a view ray of its own does not have.
inline Command of_picture(std::string id, std::string name, Keys keys, std::string help,
                          std::function<void(Explorer&)> run) {
    return {std::move(id), std::move(name), std::move(keys), std::move(help), std::move(run), has_picture};
}

// The menus that stand in a file of their own (command_list_plot.cpp).
void add_compare(List& list);
void add_plot(List& list);

}  // namespace momentscope::ui
