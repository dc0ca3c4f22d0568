// effort.hpp -- the effort of random tests.
#pragma once
#include <cstdlib>
#include <string_view>

namespace momentscope::test {

/// The number of random inputs of a test: `usual`, or `thorough` if the environment variable
/// MOMENTSCOPE_THOROUGH is 1, or a twentieth under sanitizers, because these do not look for wrong numbers.
/// At least 1.
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
