#include "core/support/parallel_for.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace momentscope::test {
namespace {

TEST(ParallelFor, CallsEachIndexOnce) {
    std::vector<std::atomic<int>> calls(1000);
    parallel_for(calls.size(), [&](std::size_t i) { ++calls[i]; });
    for (const auto& count : calls) EXPECT_EQ(count, 1);
    parallel_for(0, [](std::size_t) { FAIL(); });
}

TEST(ParallelFor, HandsOnAnException) {
    EXPECT_THROW(parallel_for(100,
                              [](std::size_t i) {
                                  if (i == 3) throw std::runtime_error("three");
                              }),
                 std::runtime_error);
}

TEST(ParallelFor, EndsAfterAStop) {
    std::stop_source stop;
    std::atomic<int> calls = 0;
    parallel_for(
        1'000'000,
        [&](std::size_t) {
            ++calls;
            stop.request_stop();
        },
        stop.get_token());
    EXPECT_LT(calls, 1000) << "at most one call of each thread after the stop";
}

}  // namespace
}  // namespace momentscope::test
