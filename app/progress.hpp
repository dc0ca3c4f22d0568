// progress.hpp -- long work on the command line: how far it is, and Ctrl+C that ends it in order.
#pragma once
#include <array>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

#include "core/error.hpp"

namespace momentscope {

/// The user ended the work by a signal: what() says what there is of it. The program ends by that signal.
class Interrupted : public Error {
public:
    Interrupted(const std::string& sentence, int by) : Error(sentence), signal(by) {}
    int signal;
};

/// While it lives, Ctrl+C and SIGTERM ask its token to stop instead of ending the program, and one line on
/// standard error is kept up to date, where that is a terminal. Work that does not stop within PATIENCE, such
/// as a picture that the GL draws, is cut off, but for a file that is being written: the program says its
/// farewell and ends by that signal. A second one ends it at once. One lives at a time.
class Progress {
public:
    static constexpr std::chrono::milliseconds PATIENCE{300};

    /// `farewell` is the sentence after Ctrl+C; "WHAT was ended before it was done; nothing was written." if
    /// none is given. Another thread may ask for it.
    explicit Progress(std::string what, std::function<std::string()> farewell = {});
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// How much is done, and how long the rest will take. May be called by any thread.
    void show(std::size_t done, std::size_t all);

    /// What is being done where nothing can be counted; it is shown with the seconds since it began.
    void show_stage(std::string stage);

    std::stop_token stop() const { return stop_.get_token(); }

    /// Throws Interrupted with the farewell when Ctrl+C was pressed.
    void require_finished() const;

private:
    void watch(const std::stop_token& end);
    void cut_off(const std::stop_token& end);
    void show_seconds();
    void show_line(const std::string& line);
    void clear_line();

    std::string what_;
    std::function<std::string()> farewell_;
    std::stop_source stop_;
    std::mutex mutex_;  // of what is shown
    std::chrono::steady_clock::time_point begin_, stage_begin_;
    std::string stage_, shown_;
    std::optional<std::size_t> percent_;  // of what is counted, while something is
    int errors_;                          // standard error, also while libraries are kept from it
    bool terminal_;
    std::array<void (*)(int), 2> handlers_{};  // of the signals before
    std::mutex waiting_;
    std::condition_variable_any wake_;
    std::jthread watcher_;  // last: it uses what stands before
};

}  // namespace momentscope
