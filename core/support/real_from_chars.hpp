// real_from_chars.hpp -- std::from_chars for decimal numbers, which libc++ 19 has only for whole numbers.
#pragma once
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <string>
#include <string_view>
#include <type_traits>

namespace momentscope {

/// std::from_chars if the library has it. Otherwise the same from strtod, for texts that are a decimal number
/// as a whole; other texts are invalid. (The program does not change the decimal point of the C library.)
template <typename T>
std::from_chars_result real_from_chars(std::string_view text, T& value) {
    const char* const first = text.data();
#ifdef __cpp_lib_to_chars
    return std::from_chars(first, first + text.size(), value);
#else
    const std::string copy(text);  // ends in a zero, as strtod needs it
    const std::size_t begin = text.starts_with('-') ? 1 : 0;
    if (text.find_first_not_of("0123456789.eE+-") != text.npos ||
        text.find_first_of("0123456789.", begin) != begin)
        return {first, std::errc::invalid_argument};
    char* end = nullptr;
    errno = 0;
    T number = 0;
    if constexpr (std::is_same_v<T, float>)
        number = std::strtof(copy.c_str(), &end);
    else
        number = std::strtod(copy.c_str(), &end);
    const char* const after = first + (end - copy.c_str());
    if (after == first) return {first, std::errc::invalid_argument};
    // It also says ERANGE of numbers so small that they have fewer digits.
    if (errno == ERANGE && (number == 0 || number + number == number))
        return {after, std::errc::result_out_of_range};
    value = number;
    return {after, std::errc()};
#endif
}

}  // namespace momentscope
