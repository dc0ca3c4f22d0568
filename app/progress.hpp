// progress.hpp -- long work on the command line: how far it is, and Ctrl+C that ends it in order.
#pragma once
#include <chrono>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

namespace momentscope {

/// While it lives, Ctrl+C asks its token to stop instead of ending the program, and `show` keeps one line on
/// standard error up to date, where that is a terminal.
class Progress {
public:
    explicit Progress(std::string what);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// May be called by any thread.
    void show(std::size_t done, std::size_t all);

    std::stop_token stop() const { return stop_.get_token(); }

    /// Throws Error when Ctrl+C was pressed.
    void require_finished() const;

private:
    std::string what_;
    std::stop_source stop_;
    std::mutex mutex_;
    std::chrono::steady_clock::time_point begin_;
    int shown_percent_ = -1;
    bool terminal_;
    std::jthread watcher_;  // last: it uses what stands before
};

}  // namespace momentscope
