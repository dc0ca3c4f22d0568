// library.hpp -- is it Assimp that runs? What goes wrong in there is not our fault; the product reads
// meshes in a process of its own, because it does.
#pragma once
#include <atomic>

namespace momentscope::fuzz {

struct Library {
    std::atomic<bool> runs = false;
    std::atomic<long> memory = 0;  // KiB, the most that the process had when the library last returned
};

/// Where calls of the library are noted from now on: memory that other processes see, too.
void note_library_in(Library& library);

constexpr int LIBRARY_SECONDS = 2;  // lest broken files take all the time
constexpr int MAX_SECONDS = 10;     // for our own code

/// SIGPROF ends the process when it has run for so many seconds from now on. Those of the processor, so that
/// whatever else the machine does does not count.
void limit_time(int seconds);

/// The most memory that the process had so far, in KiB.
long most_memory();

}  // namespace momentscope::fuzz
