// input_file.hpp -- reads text files that may be broken or hostile.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

namespace momentscope {

/// The contents of the file. Throws Error if it is missing, not an ordinary file, larger than `most_bytes` or
/// unreadable. `what` names the kind of file in the sentence, such as "session".
std::string read_input_file(const std::filesystem::path& path, std::uintmax_t most_bytes, const char* what);

}  // namespace momentscope
