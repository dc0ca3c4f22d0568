#include "tests/fuzz/runner.hpp"

#include <cxxabi.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <thread>
#include <typeinfo>
#include <utility>

#include "core/support/error.hpp"
#include "tests/fuzz/library.hpp"
#include "tests/fuzz/readers.hpp"

namespace momentscope::fuzz {

namespace {

constexpr int SAID = 3;  // exit code of a process that has reported a fault

/// The data that the processes share.
struct Shared {
    std::atomic<std::uint64_t> number, inputs, stopped_in_library;
    std::atomic<long> most_memory;
    std::atomic<bool> reads;    // whether an input is being read
    std::atomic<pid_t> reader;  // the process that reads the input
    Library library;
    bool tells_refusals;
    char said[1000];
};

[[noreturn]] void end_saying(Shared& shared, const std::string& what) {
    std::strncpy(shared.said, what.c_str(), sizeof shared.said - 1);
    ::_exit(SAID);
}

std::string name_of(const std::exception& exception) {
    int status = 0;
    const std::unique_ptr<char, decltype(&std::free)> name(
        abi::__cxa_demangle(typeid(exception).name(), nullptr, nullptr, &status), std::free);
    return status == 0 ? name.get() : typeid(exception).name();
}

/// Returns if there is no fault that the process survives.
void read_here(Shared& shared, const Input& input, const std::filesystem::path& file) {
    shared.reader = ::getpid();
    shared.library.runs = false;
    shared.library.memory = 0;
    try {
        read_with(input.reader, file);
    } catch (const Error& refusal) {  // this is correct behaviour
        if (shared.tells_refusals) {
            std::printf("%s\n", refusal.what());
            std::fflush(stdout);
        }
    } catch (const std::exception& exception) {
        end_saying(shared, fmt::format("{}: {}", name_of(exception), exception.what()));
    } catch (...) {
        end_saying(shared, "something was thrown that is no exception");
    }
    const long memory = most_memory();
    if (memory <= shared.library.memory) return;  // the library took the memory, not our code
    shared.most_memory = std::max(memory, shared.most_memory.load());
    if (memory > MAX_MEMORY) end_saying(shared, fmt::format("took {} MiB of memory", memory >> 10));
}

std::string end_text(int status) {
    if (WIFEXITED(status)) return fmt::format("ended with exit code {}", WEXITSTATUS(status));
    if (WTERMSIG(status) == SIGPROF) return fmt::format("took more than {} seconds", MAX_SECONDS);
    if (WTERMSIG(status) == SIGKILL) return fmt::format("took more than {} MiB of memory", MAX_MEMORY >> 10);
    return fmt::format("was ended by {}", ::strsignal(WTERMSIG(status)));
}

void read_isolated(Shared& shared, const Input& input, const std::filesystem::path& file) {
    const pid_t child = ::fork();
    if (child < 0) end_saying(shared, "no process could be started");
    if (child == 0) {
        limit_time(MAX_SECONDS);
        read_here(shared, input, file);
        ::_exit(0);
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
    if (WIFEXITED(status) && WEXITSTATUS(status) == SAID) ::_exit(SAID);
    if (!shared.library.runs) end_saying(shared, end_text(status));
    ++shared.stopped_in_library;
    if (::ftruncate(STDERR_FILENO, 0) != 0) end_saying(shared, "the report cannot be emptied");
}

/// Reads all inputs from a number on.
[[noreturn]] void work(Shared& shared, const Source& source, std::uint64_t number,
                       const std::filesystem::path& scratch, int report) {
    ::dup2(report, STDERR_FILENO);
    note_library_in(shared.library);
    for (;; ++number) {
        const std::optional<Input> input = source(number);
        if (!input) ::_exit(0);
        const std::filesystem::path file = scratch / ("input" + input->extension);
        std::ofstream(file, std::ios::binary) << input->bytes;
        shared.number = number;
        shared.reader = ::getpid();
        shared.reads = true;
        limit_time(MAX_SECONDS);
        if (is_isolated(input->reader))
            read_isolated(shared, *input, file);
        else
            read_here(shared, *input, file);
        shared.reads = false;
        ++shared.inputs;
    }
}

long resident_memory(pid_t process) {
    std::ifstream file(fmt::format("/proc/{}/statm", process));
    long all = 0, resident = 0;
    file >> all >> resident;
    return resident * (::sysconf(_SC_PAGESIZE) >> 10);
}

/// Waits until the process ends. Kills it if it takes too much or hangs. Returns the reason, or how the
/// process ended.
std::string watched(pid_t worker, Shared& shared) {
    constexpr auto PAUSE = std::chrono::milliseconds(10);
    constexpr int MAX_PAUSES = 12'000;  // two minutes, but not if the machine sleeps
    std::string why;
    std::uint64_t number = shared.number;
    int pauses = 0, status = 0;
    for (; ::waitpid(worker, &status, WNOHANG) == 0; std::this_thread::sleep_for(PAUSE)) {
        if (std::exchange(number, shared.number.load()) != number) pauses = 0;
        const pid_t reader = shared.reader;
        if (shared.reads && ++pauses > MAX_PAUSES) {
            why = "waited for two minutes";
            ::kill(worker, SIGKILL);
        } else if (shared.reads && resident_memory(reader) > MAX_MEMORY) {
            if (reader == worker) why = fmt::format("took more than {} MiB of memory", MAX_MEMORY >> 10);
            ::kill(reader, SIGKILL);
        }
    }
    if (!why.empty() || (WIFEXITED(status) && WEXITSTATUS(status) == 0)) return why;
    return WIFEXITED(status) && WEXITSTATUS(status) == SAID ? shared.said : end_text(status);
}

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

Summary run_inputs(const Source& source, const std::filesystem::path& scratch, std::uint64_t most_faults,
                   const std::function<void(const Fault&)>& on_fault, bool tells_refusals) {
    void* memory = ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw Error("There is no memory to share; close some programs.");
    auto& shared = *new (memory) Shared();
    shared.tells_refusals = tells_refusals;
    const std::filesystem::path report = scratch / "report";
    Summary summary;
    for (std::uint64_t number = 0; summary.faults < most_faults; number = shared.number + 1) {
        const int file = ::open(report.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0644);
        std::memset(shared.said, 0, sizeof shared.said);
        shared.reads = false;
        shared.number = number;
        const pid_t worker = ::fork();
        if (worker == 0) work(shared, source, number, scratch, file);
        ::close(file);
        if (worker < 0) throw Error("No process could be started; close some programs.");
        const std::string what = watched(worker, shared);
        if (what.empty()) break;
        ++summary.faults;
        ++shared.inputs;
        on_fault({shared.number, what, text_of(report)});
    }
    summary.inputs = shared.inputs;
    summary.stopped_in_library = shared.stopped_in_library;
    summary.most_memory = shared.most_memory;
    ::munmap(memory, sizeof(Shared));
    return summary;
}

}  // namespace momentscope::fuzz
