#include "core/output_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <mutex>

#include "core/error.hpp"
#include "core/reachable.hpp"

namespace momentscope {

namespace {

std::mutex file_mutex;

// Beside the target and with its extension, which says what kind of picture it is. Its name is no longer than
// any file system bears, even when the target's is as long as can be.
std::filesystem::path partial_of(const std::filesystem::path& path) {
    constexpr std::size_t MOST_STEM = 200, MOST_EXTENSION = 16;  // of 255 bytes
    const std::string stem = path.stem().string(), extension = path.extension().string();
    return path.parent_path() / fmt::format(".{}.partial{}", stem.substr(0, MOST_STEM),
                                            extension.size() <= MOST_EXTENSION ? extension : "");
}

}  // namespace

void require_writable(const std::filesystem::path& path) {
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    absolute_path(path);
    require_reachable(path);
    std::error_code status;
    if (!path.has_filename() || std::filesystem::is_directory(path, status))
        throw Error(fmt::format("'{}' is a folder; give the name of a file.", path.string()));
    if (!std::filesystem::is_directory(folder, status))
        throw Error(
            fmt::format("There is no folder '{}'; make it first, or write elsewhere.", folder.string()));
    const bool exists = std::filesystem::exists(path, status);
    if (access((exists ? path : folder).c_str(), W_OK) != 0)
        throw Error(
            fmt::format("'{}' cannot be written; check its permissions, or write elsewhere.", path.string()));
}

FileWriting::FileWriting() {
    file_mutex.lock();
}

FileWriting::~FileWriting() {
    file_mutex.unlock();
}

void replace_file(const std::filesystem::path& path,
                  const std::function<bool(const std::filesystem::path& partial)>& write) {
    require_writable(path);
    const FileWriting now;
    const std::filesystem::path partial = partial_of(path);
    const bool written = write(partial);
    std::error_code status;
    if (written) std::filesystem::rename(partial, path, status);
    if (written && !status) return;
    std::filesystem::remove(partial, status);
    throw Error(fmt::format("'{}' could not be written; check the folder and free space.", path.string()));
}

void write_text_file(const std::string& text, const std::filesystem::path& path) {
    replace_file(path, [&](const std::filesystem::path& partial) {
        std::ofstream file(partial, std::ios::binary);
        file << text;
        file.close();
        return file.good();
    });
}

}  // namespace momentscope
