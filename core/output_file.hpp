// output_file.hpp -- writes files so that a failure loses nothing.
#pragma once
#include <filesystem>
#include <functional>
#include <string>

namespace momentscope {

/// Throws Error with the reason when a file could not be written there: a missing folder, no permission, a
/// folder, a name that is too long, a working folder that was deleted.
void require_writable(const std::filesystem::path& path);

/// Lets `write` make a temporary file beside the target, with the same extension, and renames it. `write`
/// returns whether all went well. Throws Error; an existing file then stays as it was.
void replace_file(const std::filesystem::path& path,
                  const std::function<bool(const std::filesystem::path& partial)>& write);

/// Held while replace_file() works. Who ends the program at once takes it before, so that no file is cut off.
class FileWriting {
public:
    FileWriting();
    ~FileWriting();
    FileWriting(const FileWriting&) = delete;
    FileWriting& operator=(const FileWriting&) = delete;
};

void write_text_file(const std::string& text, const std::filesystem::path& path);

}  // namespace momentscope
