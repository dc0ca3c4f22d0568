// background_work.hpp -- runs long work, such as stress and tune, beside the window, with progress and
// cancellation: in a thread of its own, or a slice in each frame where there are no threads.
#pragma once
#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <future>
#include <optional>
#include <stop_token>
#include <type_traits>
#include <utility>

#include "core/support/sliced.hpp"
#include "core/support/threads.hpp"

namespace momentscope {

/// Runs one piece of work at a time. The work returns a Result, or a Sliced<Result> if it comes in parts.
template <typename Result>
class BackgroundWork {
public:
    using Report = std::function<void(std::size_t done, std::size_t all)>;

    BackgroundWork() = default;
    ~BackgroundWork() { cancel(); }
    BackgroundWork(const BackgroundWork&) = delete;
    BackgroundWork& operator=(const BackgroundWork&) = delete;

    /// Call this only while no work is running. work(stop, report)
    template <typename Work>
    void start(Work work) {
        stop_ = {};
        done_ = 0;
        all_ = 1;
        const Report report = [this](std::size_t done, std::size_t all) {
            all_ = all;
            done_ = done;
        };
        Sliced<Result> sliced = [&] {
            if constexpr (std::is_same_v<decltype(work(stop_.get_token(), report)), Result>)
                return at_once(std::move(work), stop_.get_token(), report);
            else
                return work(stop_.get_token(), report);
        }();
        if constexpr (HAS_THREADS)
            result_ = std::async(std::launch::async,
                                 [sliced = std::move(sliced)]() mutable { return sliced.finish(); });
        else
            sliced_ = std::move(sliced);
    }
    bool busy() const { return HAS_THREADS ? result_.valid() : sliced_.has_value(); }

    /// Without threads, this is where the work goes on. Call it, or take(), in each frame.
    bool finished() {
        if (!busy()) return false;
        if constexpr (HAS_THREADS)
            return result_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
        else
            return advance();
    }
    void cancel() { stop_.request_stop(); }

    /// Ends the work, waits for that, and forgets its result.
    void discard() {
        cancel();
        result_ = {};
        sliced_.reset();
        failure_ = nullptr;
    }
    bool cancelled() const { return stop_.stop_requested(); }
    float share() const {
        return static_cast<float>(done_.load()) / static_cast<float>(std::max<std::size_t>(all_.load(), 1));
    }

    /// The result, or nullopt while the work is not finished. Throws whatever the work threw.
    std::optional<Result> take() {
        if (!finished()) return std::nullopt;
        if constexpr (HAS_THREADS) return result_.get();  // makes the future invalid, even if get() throws
        Sliced<Result> sliced = *std::exchange(sliced_, std::nullopt);
        if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
        return sliced.take();
    }

private:
    template <typename Work>
    static Sliced<Result> at_once(Work work, std::stop_token stop, Report report) {
        co_return work(stop, report);
    }

    // True at the end of the work, or if a part failed.
    bool advance() {
        constexpr std::chrono::milliseconds SLICE(20);
        const auto begun = std::chrono::steady_clock::now();
        try {
            return failure_ ||
                   sliced_->advance([&] { return std::chrono::steady_clock::now() - begun > SLICE; });
        } catch (...) {
            failure_ = std::current_exception();
            return true;
        }
    }

    std::atomic<std::size_t> done_ = 0, all_ = 1;
    std::stop_source stop_;
    std::optional<Sliced<Result>> sliced_;
    std::exception_ptr failure_;
    std::future<Result> result_;  // declared last: its destructor waits for the thread, which uses the rest
};

}  // namespace momentscope
