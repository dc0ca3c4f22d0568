// text_file.hpp -- writes text so that a failure loses nothing.
#pragma once
#include <filesystem>
#include <string>

namespace momentscope {

/// Writes to a temporary file beside the target and renames it. Throws Error.
void write_text_file(const std::string& text, const std::filesystem::path& path);

}  // namespace momentscope
