// progress.hpp -- long work on the command line: shows its progress, and lets Ctrl+C stop it cleanly.
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

#include "core/support/error.hpp"

namespace momentscope {

/// The user stopped the work by a signal. what() says which parts of the work are kept. The program then ends
/// by that signal.
class Interrupted : public Error {
public:
    Interrupted(const std::string& sentence, int by) : Error(sentence), signal(by) {}
    int signal;
};

/// During its lifetime, Ctrl+C and SIGTERM request a stop through its token instead of ending the program. If
/// standard error is a terminal, one line there shows the progress. Work that does not stop within PATIENCE,
/// such as a picture that the GL draws, is cut off as soon as no file is being written: the program prints
/// its farewell and ends by the signal. A second signal ends it at once. Only one object may exist at a time.
class Progress {
public:
    static constexpr std::chrono::milliseconds PATIENCE{300};

    /// `farewell` returns the sentence after Ctrl+C. The default is "WHAT was stopped before it was finished;
    /// nothing was written." Another thread may call it.
    explicit Progress(std::string what, std::function<std::string()> farewell = {});
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Shows how much is done and how long the rest will take. Any thread may call it.
    void show(std::size_t done, std::size_t all);

    /// Shows the current step if nothing can be counted, with the seconds since it began.
    void show_stage(std::string stage);

    std::stop_token stop() const { return stop_.get_token(); }

    /// Throws Interrupted with the farewell if Ctrl+C was pressed.
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
    std::mutex mutex_;  // protects the shown line
    std::chrono::steady_clock::time_point begin_, stage_begin_;
    std::string stage_, shown_;
    std::optional<std::size_t> percent_;  // set while something is counted
    int errors_;                          // standard error, even while libraries are kept from it
    bool terminal_;
    std::array<void (*)(int), 2> handlers_{};  // the previous handlers of the signals
    std::mutex waiting_;
    std::condition_variable_any wake_;
    std::jthread watcher_;  // declared last: it uses the members above
};

}  // namespace momentscope
