// reachable.hpp -- why a path cannot be looked up, other than that nothing exists there.
#pragma once
#include <filesystem>
#include <string>

namespace momentscope {

/// Throws Error if the system refuses to look up the path: a name is too long, a folder must not be entered,
/// or links form a circle. It does not throw if the file is missing.
void require_reachable(const std::filesystem::path& path);

/// The absolute path. Throws Error if the path is relative and the working folder was deleted.
std::filesystem::path absolute_path(const std::filesystem::path& path);

/// True if both paths name the same file, whatever the names and links.
bool same_file(const std::string& a, const std::string& b);

}  // namespace momentscope
