// mutate.hpp -- makes inputs that are nearly right: a seed with a few changes.
#pragma once
#include <cstdint>
#include <vector>

#include "tests/fuzz/input.hpp"

namespace momentscope::fuzz {

/// The input with this number. All inputs of a run differ. The same number gives the same input in every run
/// with the same seeds and the same random seed. All readers get the same number of inputs.
Input mutated_input(const std::vector<Input>& seeds, std::uint64_t random_seed, std::uint64_t number);

}  // namespace momentscope::fuzz
