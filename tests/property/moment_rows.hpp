// moment_rows.hpp -- which techniques have moments, and their names in tests.
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

inline std::vector<const Technique*> moment_based_techniques() {
    std::vector<const Technique*> rows;
    for (const Technique& row : techniques())
        if (row.kernel != nullptr) rows.push_back(&row);
    return rows;
}

}  // namespace momentscope::test
