// crashing_library.cpp -- a library that crashes while the program starts.
#include <csignal>

namespace {

[[gnu::constructor]] void crash() {
    std::raise(SIGSEGV);
}

}  // namespace
