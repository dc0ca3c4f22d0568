// sliced.hpp -- long work in parts, which can pause after each of them. Threads run the parts at the same
// time; where there are none, the window runs a few parts in each frame.
#pragma once
#include <coroutine>
#include <cstddef>
#include <exception>
#include <functional>
#include <optional>
#include <stop_token>
#include <utility>

#include "core/support/parallel_for.hpp"

namespace momentscope {

/// `co_await Parts(count, work, stop)` in a Sliced function: calls work(i) for each i below `count`, in any
/// order. After a stop no further call begins.
class Parts {
public:
    Parts(std::size_t count, std::function<void(std::size_t)> work, std::stop_token stop)
        : count_(count), work_(std::move(work)), stop_(std::move(stop)) {}

    void run_all() const { parallel_for(count_, work_, stop_); }

    /// Runs the next part. False if there is none.
    bool run_next() {
        if (next_ >= count_ || stop_.stop_requested()) return false;
        work_(next_++);
        return true;
    }

    // For co_await: the function pauses here, and its promise knows the parts.
    static bool await_ready() { return false; }
    template <typename Promise>
    void await_suspend(std::coroutine_handle<Promise> function) {
        function.promise().parts = this;
    }
    static void await_resume() {}

private:
    std::size_t count_;
    std::size_t next_ = 0;
    std::function<void(std::size_t)> work_;
    std::stop_token stop_;
};

/// What a function returns that works in parts. It takes its parameters by value, because it goes on after
/// the call.
template <typename Result>
class Sliced {
public:
    struct promise_type {
        std::optional<Result> result;
        std::exception_ptr failure;
        Parts* parts = nullptr;  // that the function waits for

        Sliced get_return_object() { return Sliced(Handle::from_promise(*this)); }
        static std::suspend_always initial_suspend() noexcept { return {}; }
        static std::suspend_always final_suspend() noexcept { return {}; }
        void return_value(Result value) { result = std::move(value); }
        void unhandled_exception() { failure = std::current_exception(); }
    };

    Sliced(Sliced&& other) noexcept : function_(std::exchange(other.function_, {})) {}
    Sliced& operator=(Sliced&& other) noexcept {
        std::swap(function_, other.function_);
        return *this;
    }
    Sliced(const Sliced&) = delete;
    Sliced& operator=(const Sliced&) = delete;
    ~Sliced() {
        if (function_) function_.destroy();
    }

    /// Runs to the end, on all cores, and returns the result. Throws whatever the work throws.
    Result finish() {
        while (!function_.done()) {
            if (const Parts* parts = waits_for()) parts->run_all();
            function_.resume();
        }
        return take();
    }

    /// Runs parts one after another until enough() says so after one, or until the end. True at the end.
    /// Throws whatever a part throws.
    template <typename Enough>
    bool advance(const Enough& enough) {
        while (!function_.done()) {
            if (Parts* parts = function_.promise().parts)
                while (parts->run_next())
                    if (enough()) return false;
            function_.promise().parts = nullptr;
            function_.resume();
        }
        return true;
    }

    /// The result, once, after the end. Throws whatever the function threw.
    Result take() {
        if (function_.promise().failure) std::rethrow_exception(function_.promise().failure);
        return *std::move(function_.promise().result);
    }

private:
    using Handle = std::coroutine_handle<promise_type>;
    explicit Sliced(Handle function) : function_(function) {}

    const Parts* waits_for() { return std::exchange(function_.promise().parts, nullptr); }

    Handle function_;
};

}  // namespace momentscope
