// parallel_for.hpp -- independent pieces of work on all processor cores.
#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <stop_token>
#include <thread>
#include <vector>

#include "core/support/threads.hpp"

namespace momentscope {

/// Calls work(i) for each i below `count`, in any order and from several threads at a time, and returns when
/// all calls have ended. After a stop no further call begins. If calls throw, no further call begins, either,
/// and one of the exceptions is thrown at the end.
template <typename Work>
void parallel_for(std::size_t count, const Work& work, const std::stop_token& stop = {}) {
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> failed = false;
    std::exception_ptr failure;
    const auto run = [&] {
        try {
            for (std::size_t i = next++; i < count && !failed && !stop.stop_requested(); i = next++) work(i);
        } catch (...) {
            if (!failed.exchange(true)) failure = std::current_exception();
        }
    };
    {
        const unsigned cores = HAS_THREADS ? std::max(std::thread::hardware_concurrency(), 1U) : 1;
        const std::size_t threads = std::min<std::size_t>(cores, count);
        std::vector<std::jthread> workers;  // their destructors wait
        for (std::size_t i = 1; i < threads; ++i) workers.emplace_back(run);
        run();
    }
    if (failure) std::rethrow_exception(failure);
}

}  // namespace momentscope
