// input_file.hpp -- reads text files that cannot be trusted.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

namespace momentscope {

/// The whole file. Throws Error when it is missing, no file, larger than `most_bytes` or unreadable; `what`
/// names it there, as "session".
std::string read_input_file(const std::filesystem::path& path, std::uintmax_t most_bytes, const char* what);

}  // namespace momentscope
