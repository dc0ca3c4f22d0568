#include "app/end_by_signal.hpp"

#include <unistd.h>

#include <csignal>

#include "core/support/output_file.hpp"

namespace momentscope {

void end_cleanly_on_signals() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        if (std::signal(signal, end_by_signal) == SIG_IGN) std::signal(signal, SIG_IGN);
}

void end_by_signal(int signal) {
    remove_unfinished_file();
    std::signal(signal, SIG_DFL);
    sigset_t one;
    ::sigemptyset(&one);
    ::sigaddset(&one, signal);
    ::pthread_sigmask(SIG_UNBLOCK, &one, nullptr);  // the signal is blocked in its own handler
    ::kill(::getpid(), signal);
    // Reached only if the signal cannot end this process, such as the first process of a container.
    ::_exit(128 + signal);
}

}  // namespace momentscope
