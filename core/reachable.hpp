// reachable.hpp -- why a path leads nowhere, other than that nothing is there.
#pragma once
#include <filesystem>
#include <string>

namespace momentscope {

/// Throws Error when the system refuses to look a path up: a name that is too long, a folder that may not be
/// entered, links in a circle. A missing file is no such reason.
void require_reachable(const std::filesystem::path& path);

/// The path from the root on. Throws Error when it starts in a working folder that was deleted.
std::filesystem::path absolute_path(const std::filesystem::path& path);

/// Do both name one file, by whatever names and links?
bool same_file(const std::string& a, const std::string& b);

}  // namespace momentscope
