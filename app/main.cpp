#include "app/command_line.hpp"
#include "app/crash_sentence.hpp"

namespace {

void guard_libraries(int /*argc*/, char** /*argv*/, char** /*environment*/) {
    momentscope::say_on_crash(
        "A library crashed while the program started; give the program more memory, or reinstall its libraries.");
}

// The dynamic loader calls this before the libraries construct their static objects, which can fail if there
// is little memory.
#ifndef __SANITIZE_ADDRESS__
[[gnu::section(".preinit_array"), gnu::used]] void (*const before_libraries)(int, char**,
                                                                             char**) = guard_libraries;
#endif

}  // namespace

int main(int argc, char** argv) {
    momentscope::say_on_crash(nullptr);
    return momentscope::run_command_line(argc, argv);
}
