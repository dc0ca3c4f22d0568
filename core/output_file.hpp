// output_file.hpp -- writes files so that a failure loses nothing.
#pragma once
#include <filesystem>
#include <string_view>

namespace momentscope {

/// Throws Error with the reason when a file could not be written there: a missing folder, no permission for
/// the file or its folder, a folder, a device or pipe, a name that is too long, a working folder that was
/// deleted.
void require_writable(const std::filesystem::path& path);

/// Makes the file hold these bytes, or throws Error and leaves what was there as it was. The bytes go to a
/// new file beside it, are brought to the disk, and then get the name, so that nobody ever reads a part of
/// them. A file that is replaced keeps its permissions; of a symbolic link, what it points to is replaced.
void write_file(std::string_view bytes, const std::filesystem::path& path);

/// Removes what write_file has begun and not finished. For handlers of signals that end the program.
void remove_unfinished_file() noexcept;

/// Held while write_file() works. Who ends the program at once takes it before, so that no file is cut off.
class FileWriting {
public:
    FileWriting();
    ~FileWriting();
    FileWriting(const FileWriting&) = delete;
    FileWriting& operator=(const FileWriting&) = delete;
};

}  // namespace momentscope
