#include "core/support/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <mutex>
#include <optional>
#include <random>
#include <string>
#include <system_error>

#include "core/support/error.hpp"
#include "core/support/reachable.hpp"

namespace momentscope {

namespace {

std::mutex file_mutex;  // one file at a time; a signal handler knows its name

namespace fs = std::filesystem;

// The name of the file that is being written, for signal handlers.
std::array<char, PATH_MAX> unfinished_name;
std::atomic<bool> has_unfinished = false;
static_assert(std::atomic<bool>::is_always_lock_free);

/// During its life a signal handler can remove the file. The destructor removes it, too, unless it has been
/// renamed.
class Unfinished {
public:
    explicit Unfinished(const std::string& name) {
        name.copy(unfinished_name.data(), name.size());
        unfinished_name[name.size()] = '\0';
        has_unfinished = true;
    }
    ~Unfinished() {
        remove_unfinished_file();
        has_unfinished = false;
    }
    Unfinished(const Unfinished&) = delete;
    Unfinished& operator=(const Unfinished&) = delete;
};

// The target of symbolic links, even if nothing exists there yet.
fs::path target_of(fs::path path) {
    constexpr int MAX_LINKS = 40;  // as many as the system follows
    std::error_code code;
    for (int i = 0; i < MAX_LINKS && fs::is_symlink(path, code); ++i)
        path = path.parent_path() / fs::read_symlink(path, code);
    return path;
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : ".";
}

// A name that nobody can guess, so nobody can place a link or a pipe there before. It is short enough for any
// file system.
std::string random_name() {
    std::random_device random;
    return fmt::format(".momentscope-{:08x}{:08x}.partial", random(), random());
}

std::optional<struct stat> status_of(const fs::path& path) {
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0 ? std::optional(status) : std::nullopt;
}

// The following functions return 0 or the error number of the system.

int write_all(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) return errno;
        if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

// Gives the file the owner, group and permissions of the previous one, as far as the system allows. Only the
// superuser may change the owner.
int make_alike(int file, const struct stat& before) {
    struct stat now {};
    if (::fstat(file, &now) != 0) return errno;
    const bool other = now.st_uid != before.st_uid || now.st_gid != before.st_gid;
    if (other && ::fchown(file, before.st_uid, before.st_gid) != 0 && errno != EPERM) return errno;
    constexpr mode_t PERMISSIONS = 0777;
    const mode_t mode = before.st_mode & PERMISSIONS;
    return mode == (now.st_mode & PERMISSIONS) || ::fchmod(file, mode) == 0 ? 0 : errno;
}

int make_file(const fs::path& path, std::string_view bytes, const std::optional<struct stat>& before) {
    // The old file may be secret. Nobody else may read the new file before it has the same permissions.
    const mode_t mode = before ? 0600 : 0666;
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
    if (file < 0) return errno;
    int failure = write_all(file, bytes);
    if (failure == 0 && before) failure = make_alike(file, *before);
    if (failure == 0 && ::fsync(file) != 0) failure = errno;
    if (::close(file) != 0 && failure == 0) failure = errno;
    return failure;
}

// Brings the folder to the disk, so that another file which is removed afterwards does not vanish before this
// one exists. Some systems cannot do this.
void sync_folder(const fs::path& folder) {
    const int handle = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (handle < 0) return;
    ::fsync(handle);
    ::close(handle);
}

}  // namespace

void require_writable(const fs::path& path) {
    absolute_path(path);
    require_reachable(path);
    const fs::path target = target_of(path), folder = folder_of(target);
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    if (!path.has_filename() || fs::is_directory(status))
        throw Error(fmt::format("'{}' is a folder; give the name of a file.", path.string()));
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw Error(fmt::format(
            "'{}' is a device or a pipe, which is never replaced; give the name of a file.", path.string()));
    if (!fs::is_directory(folder, code))
        throw Error(
            fmt::format("There is no folder '{}'; make it first, or write elsewhere.", folder.string()));
    if (fs::exists(status) && ::access(target.c_str(), W_OK) != 0)
        throw Error(
            fmt::format("'{}' cannot be written; check its permissions, or write elsewhere.", path.string()));
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        throw Error(
            fmt::format("'{}' cannot be written in the folder '{}'; check its permissions, or write "
                        "elsewhere.",
                        path.string(), folder.string()));
}

FileWriting::FileWriting() {
    file_mutex.lock();
}

FileWriting::~FileWriting() {
    file_mutex.unlock();
}

void write_file(std::string_view bytes, const fs::path& path) {
    require_writable(path);
    const FileWriting now;
    const fs::path target = target_of(path), folder = folder_of(target);
    const fs::path temporary = folder / random_name();
    int failure = ENAMETOOLONG;
    if (temporary.string().size() < unfinished_name.size()) {
        const Unfinished unfinished(temporary.string());
        failure = make_file(temporary, bytes, status_of(target));
        if (failure == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) failure = errno;
    }
    if (failure != 0)
        throw Error(fmt::format("'{}' could not be written ({}); check the folder and free space.",
                                path.string(), std::generic_category().message(failure)));
    sync_folder(folder);
}

void remove_unfinished_file() noexcept {
    if (has_unfinished) ::unlink(unfinished_name.data());
}

}  // namespace momentscope
