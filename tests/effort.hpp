// effort.hpp -- how much random tests look at.
#pragma once
#include <cstdlib>
#include <string_view>

namespace momentscope::test {

/// How many random inputs a test looks at: `usual`, `thorough` where the variable MOMENTSCOPE_THOROUGH is 1,
/// or a twentieth under sanitizers, which look for other faults than wrong numbers. At least 1.
inline int effort(int usual, int thorough) {
#ifdef MOMENTSCOPE_SANITIZE
    static_cast<void>(thorough);
    return usual / 20 + 1;
#else
    const char* text = std::getenv("MOMENTSCOPE_THOROUGH");
    return text != nullptr && std::string_view(text) == "1" ? thorough : usual;
#endif
}

}  // namespace momentscope::test
