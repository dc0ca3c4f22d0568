// background_work.hpp -- runs long work, such as stress and tune, in a thread of its own, with progress and
// cancellation.
#pragma once
#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <optional>
#include <stop_token>
#include <utility>

namespace momentscope {

/// Runs one piece of work at a time. The work returns a Result.
template <typename Result>
class BackgroundWork {
public:
    using Report = std::function<void(std::size_t done, std::size_t all)>;
    using Work = std::function<Result(std::stop_token, const Report&)>;

    BackgroundWork() = default;
    ~BackgroundWork() { cancel(); }
    BackgroundWork(const BackgroundWork&) = delete;
    BackgroundWork& operator=(const BackgroundWork&) = delete;

    /// Call this only while no work is running.
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
    bool finished() const {
        return busy() && result_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    }
    void cancel() { stop_.request_stop(); }

    /// Ends the work, waits for that, and forgets its result.
    void discard() {
        cancel();
        result_ = {};
    }
    bool cancelled() const { return stop_.stop_requested(); }
    float share() const {
        return static_cast<float>(done_.load()) / static_cast<float>(std::max<std::size_t>(all_.load(), 1));
    }

    /// The result, or nullopt while the work is not finished. Throws whatever the work threw.
    std::optional<Result> take() {
        if (!finished()) return std::nullopt;
        return result_.get();  // makes the future invalid, even if get() throws
    }

private:
    std::atomic<std::size_t> done_ = 0, all_ = 1;
    std::stop_source stop_;
    std::future<Result> result_;  // declared last: its destructor waits for the thread, which uses the rest
};

}  // namespace momentscope
