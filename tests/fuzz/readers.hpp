// readers.hpp -- what reads the files of users, and what must hold of whatever it has read.
#pragma once
#include <filesystem>
#include <stdexcept>
#include <string_view>

namespace momentscope::fuzz {

/// What was read is not what a reader promises.
class BrokenPromise : public std::logic_error {
public:
    using std::logic_error::logic_error;
};

/// Reads the file as the product does, and writes again what was read. Throws Error when the reader refuses
/// it, and anything else only for a fault.
void read_with(std::string_view reader, const std::filesystem::path& file);

/// May a reader crash, because a library does? Such a one is run in a process of its own.
bool is_isolated(std::string_view reader);

}  // namespace momentscope::fuzz
