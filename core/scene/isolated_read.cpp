// isolated_read.cpp -- fork, read, send the mesh and its warnings home through a pipe.
//
// The pipe carries one byte, then either the text of an Error or a Header, three arrays and
// the warnings, each of which ends in a line feed. Both ends
// are the same program, so that no byte order or padding needs care.
#include "core/scene/isolated_read.hpp"

#include "core/error.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <sstream>
#include <string>

namespace momentscope {
namespace {

constexpr char IS_MESH = 'M';
constexpr char IS_ERROR = 'E';
constexpr rlim_t MEMORY_LIMIT = rlim_t{8} << 30;  // bytes; 20 million triangles fit

struct Header {
    std::size_t vertex_count;
    std::size_t index_count;
    std::size_t warning_bytes;
};

/// Writes everything, or ends the process: without a reader there is nothing left to do.
void write_all(int pipe, const void* data, std::size_t size) {
    const char* next = static_cast<const char*>(data);
    while (size > 0) {
        const ssize_t written = ::write(pipe, next, size);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) ::_exit(1);
        next += written;
        size -= static_cast<std::size_t>(written);
    }
}

/// Reads until the other end closes or a stop is requested.
std::vector<char> read_all(int pipe, const std::stop_token& stop) {
    constexpr int STOP_CHECK_MS = 50;
    std::vector<char> bytes;
    std::vector<char> chunk(std::size_t{1} << 16);
    while (!stop.stop_requested()) {
        pollfd ready{pipe, POLLIN, 0};
        if (::poll(&ready, 1, STOP_CHECK_MS) == 0) continue;
        const ssize_t got = ::read(pipe, chunk.data(), chunk.size());
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return bytes;
        bytes.insert(bytes.end(), chunk.begin(), chunk.begin() + got);
    }
    return bytes;
}

/// Bounds time and memory, and keeps the library's messages and core files out of the user's way.
void limit_process(unsigned seconds) {
    const auto limit = [](auto resource, rlim_t value) {
        const rlimit both{value, value};
        ::setrlimit(resource, &both);
    };
    limit(RLIMIT_CORE, 0);
#ifndef __SANITIZE_ADDRESS__  // the sanitizer reserves terabytes
    limit(RLIMIT_DATA, MEMORY_LIMIT);
#endif
    // A crash must end this process in silence, whatever handlers the program has.
    for (const int signal : {SIGALRM, SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL}) ::signal(signal, SIG_DFL);
    ::alarm(seconds);
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
}

/// The forked process from its beginning to its end.
[[noreturn]] void serve(const std::function<LoadedMesh()>& read, int pipe) {
    try {
        const LoadedMesh loaded = read();
        const Mesh& mesh = loaded.mesh;
        if (mesh.normals.size() != mesh.positions.size()) ::_exit(1);
        std::string warnings;
        for (const std::string& warning : loaded.warnings) warnings += warning + '\n';
        const Header header{mesh.positions.size(), mesh.indices.size(), warnings.size()};
        write_all(pipe, &IS_MESH, 1);
        write_all(pipe, &header, sizeof header);
        write_all(pipe, mesh.positions.data(), mesh.positions.size() * sizeof(glm::vec3));
        write_all(pipe, mesh.normals.data(), mesh.normals.size() * sizeof(glm::vec3));
        write_all(pipe, mesh.indices.data(), mesh.indices.size() * sizeof(std::uint32_t));
        write_all(pipe, warnings.data(), warnings.size());
    } catch (const Error& error) {
        write_all(pipe, &IS_ERROR, 1);
        write_all(pipe, error.what(), std::strlen(error.what()));
    } catch (...) {
        ::_exit(1);
    }
    ::_exit(0);  // not exit(): the parent's open files and GL contexts must not be closed from here
}

/// The mesh in the bytes, unless they are too few or too many or an index is wild: a library that ran
/// over its own memory may well send something odd.
std::optional<LoadedMesh> unpack(const std::vector<char>& bytes) {
    Header header{};
    if (bytes.size() < 1 + sizeof header) return std::nullopt;
    std::memcpy(&header, bytes.data() + 1, sizeof header);
    const std::size_t most = bytes.size();  // keeps the products below from overflowing
    if (std::max({header.vertex_count, header.index_count, header.warning_bytes}) > most) return std::nullopt;
    const std::size_t vertex_bytes = header.vertex_count * sizeof(glm::vec3);
    const std::size_t index_bytes = header.index_count * sizeof(std::uint32_t);
    if (bytes.size() != 1 + sizeof header + 2 * vertex_bytes + index_bytes + header.warning_bytes)
        return std::nullopt;

    LoadedMesh loaded;
    Mesh& mesh = loaded.mesh;
    mesh.positions.resize(header.vertex_count);
    mesh.normals.resize(header.vertex_count);
    mesh.indices.resize(header.index_count);
    const char* next = bytes.data() + 1 + sizeof header;
    std::memcpy(mesh.positions.data(), next, vertex_bytes);
    std::memcpy(mesh.normals.data(), next + vertex_bytes, vertex_bytes);
    std::memcpy(mesh.indices.data(), next + 2 * vertex_bytes, index_bytes);
    std::istringstream warnings(std::string(next + 2 * vertex_bytes + index_bytes, header.warning_bytes));
    for (std::string warning; std::getline(warnings, warning);) loaded.warnings.push_back(warning);
    const bool tame = std::all_of(mesh.indices.begin(), mesh.indices.end(),
                                  [&](std::uint32_t index) { return index < header.vertex_count; });
    if (!tame || header.index_count % 3 != 0) return std::nullopt;
    return loaded;
}

}  // namespace

std::optional<LoadedMesh> read_isolated(const std::function<LoadedMesh()>& read, unsigned seconds,
                                        const std::stop_token& stop) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0)
        throw Error("There are too many open files; close some and try again.");
    const pid_t child = ::fork();
    if (child == 0) {
        ::close(ends[0]);
        limit_process(seconds);
        serve(read, ends[1]);
    }
    ::close(ends[1]);
    const std::vector<char> bytes = child > 0 ? read_all(ends[0], stop) : std::vector<char>();
    ::close(ends[0]);
    if (child < 0)
        throw Error("No process could be started to read the mesh; close some programs and try again.");

    if (stop.stop_requested()) ::kill(child, SIGKILL);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (stop.stop_requested()) throw Error("Reading the mesh was cancelled; the last scene stays.");
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || bytes.empty()) return std::nullopt;
    if (bytes.front() == IS_ERROR) throw Error(std::string(bytes.begin() + 1, bytes.end()));
    return unpack(bytes);
}

}  // namespace momentscope
