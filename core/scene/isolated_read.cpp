// isolated_read.cpp -- forks, reads, and sends the mesh and its warnings back through a pipe.
//
// The pipe carries messages. Each begins with one byte. A message is either a report of what is being done,
// as a text; or, at the end, the text of an Error; or, at the end, a Header, three arrays and the warnings,
// each of which ends in a line feed. A text is its length and its bytes. Both ends are the same program, so
// byte order and padding need no care.
#include "core/scene/isolated_read.hpp"

#include "core/scene/mesh_file.hpp"
#include "core/support/error.hpp"
#include "core/support/memory.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <sstream>
#include <string>

namespace momentscope {
namespace {

constexpr char IS_REPORT = 'R';
constexpr char IS_MESH = 'M';
constexpr char IS_ERROR = 'E';
constexpr std::uintmax_t MEMORY_LIMIT = std::uintmax_t{8} << 30;  // bytes; 20 million triangles fit
constexpr std::size_t MAX_TEXT = std::size_t{1} << 20;            // bytes of a text, and of all warnings

struct Header {
    std::size_t vertex_count;
    std::size_t index_count;
    std::size_t warning_bytes;
};

/// The writing end of the pipe. If something cannot be written, the process ends: without a parent there is
/// nothing left to do.
class Sender {
public:
    explicit Sender(int pipe) : pipe_(pipe) {}

    void write(const void* data, std::size_t size) const {
        const char* next = static_cast<const char*>(data);
        while (size > 0) {
            const ssize_t written = ::write(pipe_, next, size);
            if (written < 0 && errno == EINTR) continue;
            if (written <= 0) ::_exit(1);
            next += written;
            size -= static_cast<std::size_t>(written);
        }
    }
    void write_text(char kind, const std::string& text) const {
        const std::size_t size = std::min(text.size(), MAX_TEXT);
        write(&kind, 1);
        write(&size, sizeof size);
        write(text.data(), size);
    }
    void write_mesh(const LoadedMesh& loaded) const {
        const Mesh& mesh = loaded.mesh;
        if (mesh.normals.size() != mesh.positions.size()) ::_exit(1);
        std::string warnings;
        for (const std::string& warning : loaded.warnings) warnings += warning + '\n';
        const Header header{mesh.positions.size(), mesh.indices.size(), std::min(warnings.size(), MAX_TEXT)};
        write(&IS_MESH, 1);
        write(&header, sizeof header);
        write(mesh.positions.data(), mesh.positions.size() * sizeof(glm::vec3));
        write(mesh.normals.data(), mesh.normals.size() * sizeof(glm::vec3));
        write(mesh.indices.data(), mesh.indices.size() * sizeof(std::uint32_t));
        write(warnings.data(), header.warning_bytes);
    }

private:
    int pipe_;
};

/// The reading end of the pipe.
class Receiver {
public:
    Receiver(int pipe, const std::stop_token& stop) : pipe_(pipe), stop_(stop) {}

    /// Reads `size` bytes. False if the pipe ends before that, or if a stop is requested.
    bool read(void* data, std::size_t size) const {
        constexpr int STOP_CHECK_MS = 50;
        char* next = static_cast<char*>(data);
        while (size > 0) {
            if (stop_.stop_requested()) return false;
            pollfd ready{pipe_, POLLIN, 0};
            if (::poll(&ready, 1, STOP_CHECK_MS) == 0) continue;
            const ssize_t got = ::read(pipe_, next, size);
            if (got < 0 && errno == EINTR) continue;
            if (got <= 0) return false;
            next += got;
            size -= static_cast<std::size_t>(got);
        }
        return true;
    }
    std::optional<std::string> read_text() const {
        std::size_t size = 0;
        if (!read(&size, sizeof size) || size > MAX_TEXT) return std::nullopt;
        return read_bytes(size);
    }
    std::optional<LoadedMesh> read_mesh(const ReadReport& report) const;

private:
    std::optional<std::string> read_bytes(std::size_t size) const {
        std::string bytes(size, '\0');
        if (!read(bytes.data(), size)) return std::nullopt;
        return bytes;
    }
    template <typename T>
    bool read_array(std::vector<T>& array, std::size_t size) const {
        array.resize(size);
        return read(array.data(), size * sizeof(T));
    }

    int pipe_;
    const std::stop_token& stop_;
};

/// The mesh; nullopt if it ends too early or an index is out of range. A library that has overwritten its own
/// memory may send anything.
std::optional<LoadedMesh> Receiver::read_mesh(const ReadReport& report) const {
    Header header{};
    constexpr std::size_t MAX_COUNT = 3 * MAX_MESH_TRIANGLES;
    if (!read(&header, sizeof header) || header.vertex_count > MAX_COUNT || header.index_count > MAX_COUNT ||
        header.warning_bytes > MAX_TEXT || header.index_count % 3 != 0)
        return std::nullopt;
    const std::string triangles = std::to_string(header.index_count / 3) + " triangles";
    const std::size_t bytes =
        2 * header.vertex_count * sizeof(glm::vec3) + header.index_count * sizeof(std::uint32_t);
    if (report) report("taking " + memory_text(bytes) + " of memory for " + triangles);
    require_memory(bytes, "The mesh of " + triangles, "simplify it");

    LoadedMesh loaded;
    Mesh& mesh = loaded.mesh;
    if (!read_array(mesh.positions, header.vertex_count) || !read_array(mesh.normals, header.vertex_count) ||
        !read_array(mesh.indices, header.index_count))
        return std::nullopt;
    const std::optional<std::string> text = read_bytes(header.warning_bytes);
    if (!text) return std::nullopt;
    std::istringstream warnings(*text);
    for (std::string warning; std::getline(warnings, warning);) loaded.warnings.push_back(warning);
    const bool tame =
        std::ranges::all_of(mesh.indices, [&](std::uint32_t index) { return index < header.vertex_count; });
    return tame ? std::optional(std::move(loaded)) : std::nullopt;
}

/// Makes this process end when its parent ends, for whatever reason. The parent may have ended already.
void end_with(pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(1);
}

/// Limits time and memory, and suppresses messages of the library and core files.
void limit_process(unsigned seconds) {
    const auto limit = [](auto resource, rlim_t value) {
        const rlimit both{value, value};
        ::setrlimit(resource, &both);
    };
    limit(RLIMIT_CORE, 0);
#ifndef __SANITIZE_ADDRESS__  // the sanitizer reserves terabytes of address space
    limit(RLIMIT_DATA, std::min(MEMORY_LIMIT, own_memory() + free_memory().value_or(MEMORY_LIMIT)));
#endif
    // A crash must end this process silently, whatever handlers the program has.
    for (const int signal : {SIGALRM, SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL}) ::signal(signal, SIG_DFL);
    // Ctrl+C goes to both processes. The parent decides what to do; if this process ended, the parent would
    // take the file for broken.
    ::signal(SIGINT, SIG_IGN);
    ::alarm(seconds);
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
}

/// Runs the forked process from its beginning to its end.
[[noreturn]] void serve(const IsolatedReader& read, const Sender& home) {
    try {
        home.write_mesh(read([&](const std::string& what) { home.write_text(IS_REPORT, what); }));
    } catch (const Error& error) {
        home.write_text(IS_ERROR, error.what());
    } catch (...) {
        ::_exit(1);
    }
    ::_exit(0);  // not exit(), which would close open files and GL contexts of the parent
}

/// What a reader sends back.
struct Answer {
    std::optional<LoadedMesh> mesh;
    std::optional<std::string> error;
};

Answer answer_of(const Receiver& child, const ReadReport& report) {
    for (char kind = 0; child.read(&kind, 1);) {
        if (kind == IS_MESH) return {child.read_mesh(report), {}};
        const std::optional<std::string> text = child.read_text();
        if (kind == IS_ERROR) return {{}, text};
        if (kind != IS_REPORT || !text) break;
        if (report) report(*text);
    }
    return {};
}

/// A forked process. The destructor ends it and waits for it.
class Child {
public:
    explicit Child(pid_t process) : process_(process) {}
    ~Child() {
        if (process_ <= 0) return;
        ::kill(process_, SIGKILL);
        wait();
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// True if the process ended normally.
    bool wait() {
        int status = 0;
        while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
        }
        process_ = 0;
        return WIFEXITED(status) && WEXITSTATUS(status) == 0;
    }

private:
    pid_t process_;
};

/// A file that the destructor closes.
struct OpenEnd {
    int file;
    explicit OpenEnd(int opened) : file(opened) {}
    ~OpenEnd() { ::close(file); }
    OpenEnd(const OpenEnd&) = delete;
    OpenEnd& operator=(const OpenEnd&) = delete;
};

}  // namespace

std::optional<LoadedMesh> read_isolated(const IsolatedReader& read, unsigned seconds,
                                        const std::stop_token& stop, const ReadReport& report) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0)
        throw Error("There are too many open files; close some and try again.");
    const pid_t parent = ::getpid();
    const pid_t process = ::fork();
    if (process == 0) {
        end_with(parent);
        ::close(ends[0]);
        limit_process(seconds);
        serve(read, Sender(ends[1]));
    }
    ::close(ends[1]);
    const OpenEnd end(ends[0]);
    if (process < 0)
        throw Error("No process could be started to read the mesh; close some programs and try again.");
    Child child(process);
    Answer answer = answer_of(Receiver(end.file, stop), report);
    if (stop.stop_requested()) throw Error("Reading the mesh was cancelled; the last scene stays.");
    // Without an answer the child may still be trying to write, so do not wait for it here.
    if ((!answer.mesh && !answer.error) || !child.wait()) return std::nullopt;
    if (answer.error) throw Error(*answer.error);
    return std::move(answer.mesh);
}

}  // namespace momentscope
