// last_words.hpp -- saves what the user had when the program must end.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "ui/state.hpp"

namespace momentscope {

/// Where programs keep what shall outlive them though no user asked for it: $XDG_STATE_HOME/momentscope,
/// ~/.local/state/momentscope, the folder of temporary files; the first that can be written is taken.
std::vector<std::filesystem::path> recovery_folders();

/// Writes the session to a new file in one of recovery_folders(), which is made if need be. Returns the
/// sentence that says how it is opened again, or why it could not be saved. Never throws.
std::string last_words(const ui::ExplorerState& state);

}  // namespace momentscope
