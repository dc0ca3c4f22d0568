// mutate.hpp -- inputs that are nearly right: a seed with a few changes.
#pragma once
#include <cstdint>
#include <vector>

#include "tests/fuzz/input.hpp"

namespace momentscope::fuzz {

/// The input of that number: all numbers of a run differ, and the same one is the same input in every run
/// with the same seeds and random seed. Each reader gets as many as any other.
Input mutated_input(const std::vector<Input>& seeds, std::uint64_t random_seed, std::uint64_t number);

}  // namespace momentscope::fuzz
