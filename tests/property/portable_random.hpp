// portable_random.hpp -- random numbers that are the same with every standard library. They are those of the
// distributions of libstdc++.
#pragma once
#include <algorithm>
#include <cstdint>
#include <random>

namespace momentscope::test {

/// A float from [low, high).
inline float uniform(std::mt19937& random, float low, float high) {
    const float share = std::min(static_cast<float>(random()) * 0x1p-32f, 0x1.fffffep-1f);
    return share * (high - low) + low;
}

/// A whole number from least to most (Lemire 2019).
inline int uniform_whole(std::mt19937& random, int least, int most) {
    const auto range = static_cast<std::uint32_t>(most - least) + 1;
    std::uint64_t product = std::uint64_t{static_cast<std::uint32_t>(random())} * range;
    while (static_cast<std::uint32_t>(product) < -range % range)
        product = std::uint64_t{static_cast<std::uint32_t>(random())} * range;
    return least + static_cast<int>(product >> 32);
}

}  // namespace momentscope::test
