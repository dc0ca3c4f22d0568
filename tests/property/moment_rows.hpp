// moment_rows.hpp -- names of techniques in tests.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "core/inspect/exact.hpp"

namespace momentscope::test {

/// An id as part of a test's name, which must not hold a minus.
inline std::string test_name(const Technique& technique) {
    std::string name = technique.id;
    std::ranges::replace(name, '-', '_');
    return name;
}

}  // namespace momentscope::test
