// fuzz_readers.cpp -- reads files that are nearly right, thousands per minute, and reports the files that
// make a reader fail. scripts/fuzz builds it with sanitizers and runs it.
#include <unistd.h>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <limits>

#include "core/support/error.hpp"
#include "core/support/plain_text.hpp"
#include "tests/fuzz/mutate.hpp"
#include "tests/fuzz/runner.hpp"

#ifdef MOMENTSCOPE_SANITIZE
// A small quarantine, because memory is limited. Leaks are not checked, because processes are ended in the
// middle of their work.
extern "C" const char* __asan_default_options() {  // AddressSanitizer's name
    return "detect_leaks=0:quarantine_size_mb=16:malloc_context_size=8";
}
#endif

namespace {

using namespace momentscope;
using namespace momentscope::fuzz;
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct Options {
    fs::path seeds, failures = "build/fuzz-failures";
    std::vector<fs::path> replayed;
    double seconds = std::numeric_limits<double>::infinity();
    std::uint64_t count = std::numeric_limits<std::uint64_t>::max(), random_seed = 1;
};

/// A folder that is removed when the program ends.
struct ScratchFolder {
    fs::path path = fs::temp_directory_path() / fmt::format("momentscope_fuzz_{}", ::getpid());
    ScratchFolder() { fs::create_directories(path); }
    ~ScratchFolder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
};

/// The file that keeps the input of a fault, in a folder with the name of its reader.
fs::path kept(const Input& input, const Options& options, std::uint64_t number) {
    fs::create_directories(options.failures / input.reader);
    const fs::path file = options.failures / input.reader /
                          fmt::format("{}-{}{}", options.random_seed, number, input.extension);
    std::ofstream(file, std::ios::binary) << input.bytes;
    return file;
}

int run(const Options& options) {
    constexpr std::uint64_t MAX_FAULTS = 20;
    constexpr std::size_t MAX_REPORT = 3000;
    const Clock::time_point begun = Clock::now();
    const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - begun).count(); };

    const bool replays = !options.replayed.empty();
    const std::vector<fs::path> files = replays ? options.replayed : files_below(options.seeds);
    std::vector<Input> seeds;
    for (const fs::path& file : files) seeds.push_back(read_input(file));
    const Source source = [&](std::uint64_t number) -> std::optional<Input> {
        if (number < seeds.size()) return seeds[number];  // the unchanged seeds come first
        const std::uint64_t mutation = number - seeds.size();
        if (replays || mutation >= options.count || seconds() >= options.seconds) return std::nullopt;
        return mutated_input(seeds, options.random_seed, mutation);
    };
    const ScratchFolder scratch;
    const auto tell = [&](const Fault& fault) {
        const bool is_file = fault.number < files.size();
        const fs::path file =
            is_file ? files[fault.number] : kept(*source(fault.number), options, fault.number - seeds.size());
        std::printf("%s %s\n  scripts/fuzz --replay %s\n%s", file.c_str(), one_line(fault.what).c_str(),
                    file.c_str(), plain_lines(fault.report.substr(0, MAX_REPORT)).c_str());
        std::fflush(stdout);
    };
    const Summary summary = run_inputs(source, scratch.path, MAX_FAULTS, tell, replays);
    const std::uint64_t plain = std::min<std::uint64_t>(seeds.size(), summary.inputs);
    std::printf(
        "%llu files and %llu mutations of them in %.0f s: %llu faults, at most %ld MiB; Assimp fell over %llu\n",
        static_cast<unsigned long long>(plain), static_cast<unsigned long long>(summary.inputs - plain),
        seconds(), static_cast<unsigned long long>(summary.faults), summary.most_memory >> 10,
        static_cast<unsigned long long>(summary.stopped_in_library));
    return summary.faults == 0 && summary.inputs > 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Reads the seeds and mutations of them, and tells which of them a reader falls over.");
    Options options;
    app.add_option("--seeds", options.seeds, "a folder with a folder of files for each reader");
    app.add_option("--replay", options.replayed,
                   "read these files alone, each in a folder called like its reader");
    app.add_option("--seconds", options.seconds, "how long new mutations are made");
    app.add_option("--count", options.count, "how many mutations at most");
    app.add_option("--seed", options.random_seed, "of random numbers: the same one makes the same mutations");
    app.add_option("--failures", options.failures, "the folder that keeps the inputs of faults");
    CLI11_PARSE(app, argc, argv);
    try {
        return run(options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
