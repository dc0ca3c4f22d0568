#include "app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <thread>

#include "core/error.hpp"

namespace momentscope {

namespace {

// A signal handler may do no more than set this.
std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

void interrupt(int) {
    interrupted = true;
}

}  // namespace

Progress::Progress(std::string what)
    : what_(std::move(what)),
      begin_(std::chrono::steady_clock::now()),
      terminal_(isatty(STDERR_FILENO) != 0) {
    interrupted = false;
    std::signal(SIGINT, interrupt);
    watcher_ = std::jthread([this](const std::stop_token& end) {
        while (!end.stop_requested()) {
            if (interrupted) stop_.request_stop();
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
    });
}

Progress::~Progress() {
    std::signal(SIGINT, SIG_DFL);
    if (terminal_ && shown_percent_ >= 0) std::fputs("\r\033[K", stderr);
}

void Progress::show(std::size_t done, std::size_t all) {
    const std::scoped_lock lock(mutex_);
    const int percent = static_cast<int>(100 * done / std::max<std::size_t>(all, 1));
    if (!terminal_ || percent == shown_percent_) return;
    shown_percent_ = percent;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
    const double left = elapsed.count() * static_cast<double>(all - done) /
                        static_cast<double>(std::max<std::size_t>(done, 1));
    std::fputs(
        fmt::format("\r{}: {} of {}, {:.0f} s left (Ctrl+C ends it)\033[K", what_, done, all, left).c_str(),
        stderr);
}

void Progress::require_finished() const {
    if (interrupted) throw Error(fmt::format("{} was ended before it was done; nothing was written.", what_));
}

}  // namespace momentscope
