// runner.hpp -- reads inputs in a separate process and detects faults there.
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "tests/fuzz/input.hpp"

namespace momentscope::fuzz {

constexpr long MAX_MEMORY = 1L << 20;  // KiB

/// The input with this number, counted from 0; nullopt at the end. Several processes call it.
using Source = std::function<std::optional<Input>(std::uint64_t number)>;

struct Fault {
    std::uint64_t number;  // number of the input
    std::string what;      // one line
    std::string report;    // report of the sanitizers, if there is one
};

struct Summary {
    std::uint64_t inputs = 0;
    std::uint64_t faults = 0;
    std::uint64_t stopped_in_library = 0;  // does not count as a fault
    long most_memory = 0;                  // KiB
};

/// Reads one input after another. A fault is a crash, a sanitizer's report, an exception other than Error,
/// more than MAX_SECONDS of processor time or more than MAX_MEMORY. Continues with the next input until there
/// are `most_faults`. Prints the sentences of refusals on request.
Summary run_inputs(const Source& source, const std::filesystem::path& scratch, std::uint64_t most_faults,
                   const std::function<void(const Fault&)>& on_fault, bool tells_refusals = false);

}  // namespace momentscope::fuzz
