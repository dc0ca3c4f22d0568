// parallel_for.hpp -- independent pieces of work on all processor cores.
#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <stop_token>
#include <thread>
#include <vector>

namespace momentscope {

/// Calls work(i) for each i below `count`, in any order and from several threads at a time, and returns when
/// all calls have ended. Work must not throw. After a stop no further call begins.
template <typename Work>
void parallel_for(std::size_t count, const Work& work, const std::stop_token& stop = {}) {
    std::atomic<std::size_t> next = 0;
    const auto run = [&] {
        for (std::size_t i = next++; i < count && !stop.stop_requested(); i = next++) work(i);
    };
    const std::size_t threads =
        std::min<std::size_t>(std::max(std::thread::hardware_concurrency(), 1U), count);
    std::vector<std::jthread> workers;  // their destructors wait
    for (std::size_t i = 1; i < threads; ++i) workers.emplace_back(run);
    run();
}

}  // namespace momentscope
