// progress.hpp -- long work on the command line: how far it is, and Ctrl+C that ends it in order.
#pragma once
#include <array>
#include <chrono>
#include <mutex>
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

/// While it lives, Ctrl+C and SIGTERM ask its token to stop instead of ending the program, a second one ends
/// it, and `show` keeps one line on standard error up to date, where that is a terminal.
class Progress {
public:
    explicit Progress(std::string what);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// May be called by any thread.
    void show(std::size_t done, std::size_t all);

    std::stop_token stop() const { return stop_.get_token(); }

    /// Throws Interrupted when Ctrl+C was pressed; `left` says what there is of the work.
    void require_finished(const std::string& left = "nothing was written") const;

    /// The same with a sentence of its own, after the token was asked to stop.
    [[noreturn]] void end(const std::string& sentence) const;

private:
    std::string what_;
    std::stop_source stop_;
    std::mutex mutex_;
    std::chrono::steady_clock::time_point begin_;
    int shown_percent_ = -1;
    bool terminal_;
    std::array<void (*)(int), 2> handlers_{};  // of the signals before
    std::jthread watcher_;                     // last: it uses what stands before
};

}  // namespace momentscope
