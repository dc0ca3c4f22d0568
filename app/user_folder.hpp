// user_folder.hpp -- the folder of the user in which the window keeps its settings and the progress of
// lessons.
#pragma once
#include <filesystem>
#include <string>

namespace momentscope {

/// $XDG_CONFIG_HOME/momentscope, or ~/.config/momentscope; empty if the environment names neither.
std::filesystem::path user_folder();

/// Writes a text to <name>.json there; makes the folder if it is missing. Throws Error that names the folder.
void keep_for_user(const std::string& name, const std::string& text);

/// The text that was kept; "" if there is none. Throws Error if it cannot be read.
std::string kept_for_user(const std::string& name);

}  // namespace momentscope
