#include "app/progress.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <optional>
#include <utility>

#include "app/end_by_signal.hpp"
#include "app/terminal.hpp"
#include "core/support/output_file.hpp"

namespace momentscope {

namespace {

constexpr int SIGNALS[] = {SIGINT, SIGTERM};
using Clock = std::chrono::steady_clock;

// The signal that arrived. A handler may do little more than set this.
std::atomic<int> interrupting = 0;
static_assert(std::atomic<int>::is_always_lock_free);

void interrupt(int signal) {
    if (interrupting.exchange(signal) != 0) end_by_signal(signal);  // the second signal
}

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

// A longer line would wrap, and the next line could not replace it.
std::size_t columns_of(int terminal) {
    constexpr std::size_t USUAL = 80, FEWEST = 20;
    winsize size{};
    if (::ioctl(terminal, TIOCGWINSZ, &size) != 0 || size.ws_col < FEWEST) return USUAL;
    return size.ws_col;
}

}  // namespace

Progress::Progress(std::string what, std::function<std::string()> farewell)
    : what_(std::move(what)),
      farewell_(std::move(farewell)),
      begin_(Clock::now()),
      stage_begin_(begin_),
      errors_(::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 0)),
      terminal_(errors_ >= 0 && ::isatty(errors_) != 0) {
    if (!farewell_)
        farewell_ = [this] {
            return fmt::format("{} was stopped before it was finished; nothing was written.", what_);
        };
    interrupting = 0;
    for (std::size_t i = 0; i < handlers_.size(); ++i) {
        handlers_[i] = std::signal(SIGNALS[i], interrupt);
        if (handlers_[i] == SIG_IGN) std::signal(SIGNALS[i], SIG_IGN);  // keep it ignored, as under nohup
    }
    watcher_ = std::jthread([this](const std::stop_token& end) { watch(end); });
}

Progress::~Progress() {
    watcher_.request_stop();
    watcher_.join();
    for (std::size_t i = 0; i < handlers_.size(); ++i) std::signal(SIGNALS[i], handlers_[i]);
    clear_line();
    if (errors_ >= 0) ::close(errors_);
}

void Progress::watch(const std::stop_token& end) {
    constexpr std::chrono::milliseconds STEP{50};
    std::optional<Clock::time_point> asked;
    std::unique_lock lock(waiting_);
    while (!end.stop_requested()) {
        wake_.wait_for(lock, end, STEP, [] { return false; });
        if (interrupting != 0 && !asked) {
            asked = Clock::now();
            stop_.request_stop();
        }
        if (asked && Clock::now() - *asked >= PATIENCE) cut_off(end);
        if (!asked) show_seconds();
    }
}

// Nothing is lost: finished parts were written when they were finished, and all resources end with the
// program, including the process that reads a mesh.
void Progress::cut_off(const std::stop_token& end) {
    const FileWriting none_is_written;
    const std::scoped_lock lock(mutex_);
    if (end.stop_requested()) return;
    clear_line();
    warn_to(errors_ >= 0 ? errors_ : STDERR_FILENO, farewell_());
    end_by_signal(interrupting);
}

void Progress::show(std::size_t done, std::size_t all) {
    const std::scoped_lock lock(mutex_);
    const std::size_t percent = 100 * done / std::max<std::size_t>(all, 1);
    if (percent_ == percent) return;
    percent_ = percent;
    const double left = seconds_since(begin_) * static_cast<double>(all - done) /
                        static_cast<double>(std::max<std::size_t>(done, 1));
    show_line(fmt::format("{}: {} of {}, {:.0f} s left (Ctrl+C stops it)", what_, done, all, left));
}

void Progress::show_stage(std::string stage) {
    const std::scoped_lock lock(mutex_);
    stage_ = std::move(stage);
    stage_begin_ = Clock::now();
    percent_.reset();
}

void Progress::show_seconds() {
    const std::scoped_lock lock(mutex_);
    if (percent_) return;
    show_line(fmt::format("{}: {}{:.0f} s (Ctrl+C stops it)", what_, stage_.empty() ? "" : stage_ + ", ",
                          seconds_since(stage_begin_)));
}

void Progress::show_line(const std::string& line) {
    if (!terminal_ || line == shown_) return;
    shown_ = line;
    write_raw(errors_, "\r" + one_line(line.substr(0, columns_of(errors_) - 1)) + "\033[K");
}

void Progress::clear_line() {
    if (terminal_ && !shown_.empty()) write_raw(errors_, "\r\033[K");
}

void Progress::require_finished() const {
    if (interrupting != 0) throw Interrupted(farewell_(), interrupting);
}

}  // namespace momentscope
