// last_words.hpp -- saves the user's session when the program must end.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "ui/model/state.hpp"

namespace momentscope {

/// The folders for files that must outlive the program although no user asked for them:
/// $XDG_STATE_HOME/momentscope, ~/.local/state/momentscope and the folder of temporary files. The first
/// writable one is used.
std::vector<std::filesystem::path> recovery_folders();

/// Writes the session to a new file in one of recovery_folders() and creates the folder if needed. Returns a
/// sentence that says how to open the session again, or why it could not be saved. Never throws.
std::string last_words(const ui::ExplorerState& state);

}  // namespace momentscope
