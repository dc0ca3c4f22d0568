// background_work.hpp -- stress and tune beside the window: a thread each, with progress and cancel.
#pragma once
#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <optional>
#include <stop_token>
#include <utility>

namespace momentscope::ui {

/// One piece of work at a time that ends in a Result.
template <typename Result>
class BackgroundWork {
public:
    using Report = std::function<void(std::size_t done, std::size_t all)>;
    using Work = std::function<Result(std::stop_token, const Report&)>;

    BackgroundWork() = default;
    ~BackgroundWork() { cancel(); }
    BackgroundWork(const BackgroundWork&) = delete;
    BackgroundWork& operator=(const BackgroundWork&) = delete;

    /// Call only when not busy.
    void start(Work work) {
        stop_ = {};
        done_ = 0;
        all_ = 1;
        result_ = std::async(std::launch::async, [this, work = std::move(work), stop = stop_.get_token()] {
            return work(stop, [this](std::size_t done, std::size_t all) {
                all_ = all;
                done_ = done;
            });
        });
    }
    bool busy() const { return result_.valid(); }
    void cancel() { stop_.request_stop(); }
    bool cancelled() const { return stop_.stop_requested(); }
    float share() const {
        return static_cast<float>(done_.load()) / static_cast<float>(std::max<std::size_t>(all_.load(), 1));
    }

    /// The result when it is there, nullopt before. Throws what the work threw.
    std::optional<Result> take() {
        if (!busy() || result_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
            return std::nullopt;
        return result_.get();
    }

private:
    std::atomic<std::size_t> done_ = 0, all_ = 1;
    std::stop_source stop_;
    std::future<Result> result_;  // last: its destructor waits for the thread, which uses what stands before
};

}  // namespace momentscope::ui
