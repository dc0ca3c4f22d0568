#include "app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <thread>

#include "app/end_by_signal.hpp"

namespace momentscope {

namespace {

constexpr int SIGNALS[] = {SIGINT, SIGTERM};

// The signal that came. A handler may do no more than set this.
std::atomic<int> interrupting = 0;
static_assert(std::atomic<int>::is_always_lock_free);

void interrupt(int signal) {
    if (interrupting.exchange(signal) != 0) end_by_signal(signal);  // nobody waits twice
}

}  // namespace

Progress::Progress(std::string what)
    : what_(std::move(what)),
      begin_(std::chrono::steady_clock::now()),
      terminal_(isatty(STDERR_FILENO) != 0) {
    interrupting = 0;
    for (std::size_t i = 0; i < handlers_.size(); ++i) {
        handlers_[i] = std::signal(SIGNALS[i], interrupt);
        if (handlers_[i] == SIG_IGN) std::signal(SIGNALS[i], SIG_IGN);  // as under nohup
    }
    watcher_ = std::jthread([this](const std::stop_token& end) {
        while (!end.stop_requested()) {
            if (interrupting != 0) stop_.request_stop();
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
    });
}

Progress::~Progress() {
    for (std::size_t i = 0; i < handlers_.size(); ++i) std::signal(SIGNALS[i], handlers_[i]);
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

void Progress::require_finished(const std::string& left) const {
    if (interrupting != 0) end(fmt::format("{} was ended before it was done; {}.", what_, left));
}

void Progress::end(const std::string& sentence) const {
    throw Interrupted(sentence, interrupting);
}

}  // namespace momentscope
