// readers.hpp -- the readers of users' files, and checks of everything that they have read.
#pragma once
#include <filesystem>
#include <stdexcept>
#include <string_view>

namespace momentscope::fuzz {

/// The content that was read violates what the reader promises.
class BrokenPromise : public std::logic_error {
public:
    using std::logic_error::logic_error;
};

/// Reads the file as the product does, and writes the content again. Throws Error if the reader refuses the
/// file; any other exception is a fault.
void read_with(std::string_view reader, const std::filesystem::path& file);

/// May the reader crash because a library does? Such a reader runs in a process of its own.
bool is_isolated(std::string_view reader);

}  // namespace momentscope::fuzz
