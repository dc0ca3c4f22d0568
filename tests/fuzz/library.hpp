// library.hpp -- tells whether Assimp is running. Faults inside Assimp are not ours; the product reads meshes
// in a separate process because of them.
#pragma once
#include <atomic>

namespace momentscope::fuzz {

struct Library {
    std::atomic<bool> runs = false;
    std::atomic<long> memory = 0;  // KiB, greatest memory of the process at the last return of the library
};

/// Sets where calls of the library are recorded from now on, in memory that other processes see, too.
void note_library_in(Library& library);

constexpr int LIBRARY_SECONDS = 2;  // so that broken files do not take all the time
constexpr int MAX_SECONDS = 10;     // limit for our own code

/// From now on, SIGPROF ends the process after this many seconds of processor time, so that other load on the
/// machine does not count.
void limit_time(int seconds);

/// The greatest memory of the process so far, in KiB.
long most_memory();

}  // namespace momentscope::fuzz
