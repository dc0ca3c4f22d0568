// output_file.hpp -- writes files so that a failure loses nothing.
#pragma once
#include <filesystem>
#include <string_view>

namespace momentscope {

/// Throws Error, with the reason, if a file could not be written there: a missing folder, no permission for
/// the file or its folder, a folder, a device or pipe, a name that is too long, a working folder that was
/// deleted.
void require_writable(const std::filesystem::path& path);

/// Writes these bytes to the file. Throws Error if this fails; then the old file stays unchanged. The bytes
/// go to a new file beside it and are brought to the disk; then the file gets its name. So nobody ever reads
/// a part of them. If a file is replaced, its permissions are kept. If the path is a symbolic link, its
/// target is replaced.
void write_file(std::string_view bytes, const std::filesystem::path& path);

/// Removes a file that write_file has begun but not finished. For handlers of signals that end the program.
void remove_unfinished_file() noexcept;

/// A lock that write_file() holds while it works. Code that ends the program at once takes it first, so that
/// no file is cut off.
class FileWriting {
public:
    FileWriting();
    ~FileWriting();
    FileWriting(const FileWriting&) = delete;
    FileWriting& operator=(const FileWriting&) = delete;
};

}  // namespace momentscope
