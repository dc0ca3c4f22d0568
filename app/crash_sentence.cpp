#include "app/crash_sentence.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstring>

namespace momentscope {

namespace {

constexpr int CRASHES[] = {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT};

std::atomic<const char*> said = nullptr;
static_assert(std::atomic<const char*>::is_always_lock_free);
alignas(16) char crash_stack[1 << 16];  // the crash may be a stack overflow

// A signal handler may do little more than write and exit.
void write_text(const char* text) {
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text, std::strlen(text));
}

void say_and_end(int) {
    write_text("momentscope: ");
    write_text(said);
    write_text("\n");
    ::_exit(1);
}

}  // namespace

const char* say_on_crash(const char* sentence) {
    const char* before = said.exchange(sentence);
#ifndef __SANITIZE_ADDRESS__
    stack_t stack{};
    stack.ss_sp = crash_stack;
    stack.ss_size = sizeof crash_stack;
    ::sigaltstack(&stack, nullptr);
    struct sigaction action {};
    action.sa_handler = sentence != nullptr ? say_and_end : SIG_DFL;
    action.sa_flags = SA_ONSTACK;
    for (const int crash : CRASHES) ::sigaction(crash, &action, nullptr);
#endif
    return before;
}

}  // namespace momentscope
