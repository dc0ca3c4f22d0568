// library.hpp -- is it Assimp that runs? What goes wrong in there is no fault of ours; the product reads
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

constexpr unsigned LIBRARY_SECONDS = 2;  // then SIGALRM ends the process, lest broken files take all the time
constexpr unsigned MOST_SECONDS = 10;    // for our own code

/// The most memory that the process had so far, in KiB.
long most_memory();

}  // namespace momentscope::fuzz
