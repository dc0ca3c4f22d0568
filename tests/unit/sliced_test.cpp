// sliced_test.cpp -- work in parts: the same result on all cores and part by part, with stops and failures.
#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>
#include <vector>

#include "core/support/sliced.hpp"

namespace momentscope {
namespace {

// The sum of the squares below `count`, in two rounds of parts.
Sliced<long> squares(std::size_t count, std::stop_token stop) {
    std::vector<long> all(count);
    co_await Parts(
        count, [&](std::size_t i) { all[i] = static_cast<long>(i); }, stop);
    co_await Parts(
        count, [&](std::size_t i) { all[i] *= all[i]; }, stop);
    co_return std::accumulate(all.begin(), all.end(), 0L);
}

Sliced<int> failing(bool in_part) {
    co_await Parts(3,
                   [&](std::size_t i) {
                       if (in_part && i == 1) throw std::runtime_error("part");
                   },
                   {});
    throw std::runtime_error("function");
    co_return 0;
}

TEST(Sliced, FinishesOnAllCores) {
    EXPECT_EQ(squares(100, {}).finish(), 328350);
    EXPECT_EQ(squares(0, {}).finish(), 0);
}

TEST(Sliced, PausesAfterAnyPart) {
    Sliced<long> work = squares(100, {});
    int pauses = 0;
    while (!work.advance([] { return true; })) ++pauses;
    EXPECT_EQ(pauses, 200) << "after each part";
    EXPECT_EQ(work.take(), 328350);
}

TEST(Sliced, AStopSkipsTheRest) {
    std::stop_source stop;
    Sliced<long> work = squares(100, stop.get_token());
    int parts = 0;
    EXPECT_FALSE(work.advance([&] { return ++parts == 5; }));
    stop.request_stop();
    EXPECT_TRUE(work.advance([] { return false; }));
    EXPECT_EQ(work.take(), 0 + 1 + 2 + 3 + 4) << "five numbers, none of them squared";
}

TEST(Sliced, ThrowsWhatItThrew) {
    for (const bool in_part : {false, true}) {
        EXPECT_THROW(failing(in_part).finish(), std::runtime_error);
        Sliced<int> work = failing(in_part);
        EXPECT_THROW(
            {
                work.advance([] { return false; });
                work.take();
            },
            std::runtime_error);
    }
}

}  // namespace
}  // namespace momentscope
