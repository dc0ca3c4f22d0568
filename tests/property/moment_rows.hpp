// moment_rows.hpp -- names of techniques in tests.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "core/inspect/exact.hpp"

namespace momentscope::test {

/// An id as part of a test's name, which must not contain a minus.
inline std::string test_name(const Technique& technique) {
    std::string name = technique.id;
    std::ranges::replace(name, '-', '_');
    return name;
}

/// One technique for each kernel: those whose estimate is chosen by parameters.
inline std::vector<const Technique*> kernel_techniques() {
    std::vector<const Technique*> rows = moment_based_techniques();
    std::erase_if(rows, [](const Technique* row) { return row->moments().estimation.has_value(); });
    return rows;
}

/// The techniques with an estimation of their own.
inline std::vector<const Technique*> interval_techniques() {
    std::vector<const Technique*> rows = moment_based_techniques();
    std::erase_if(rows, [](const Technique* row) { return !row->moments().estimation.has_value(); });
    return rows;
}

/// The techniques of kernel_techniques for which `holds` is true.
inline std::vector<const Technique*> moment_techniques_where(bool (*holds)(const Technique&)) {
    std::vector<const Technique*> rows = kernel_techniques();
    std::erase_if(rows, [holds](const Technique* row) { return !holds(*row); });
    return rows;
}

}  // namespace momentscope::test
