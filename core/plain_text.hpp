// plain_text.hpp -- text from outside that is safe to show. Names of files and texts in them may hold codes
// that a terminal obeys, and bytes that are no text.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace momentscope {

struct CodePoint {
    char32_t value;
    std::size_t bytes;
};
constexpr char32_t NO_CODE_POINT = 0xFFFFFFFF;

/// The first code point of a text that is not empty; NO_CODE_POINT, of one byte, where it is no UTF-8.
CodePoint first_code_point(std::string_view text);

bool is_utf8(std::string_view text);

/// Whether it moves what stands beside it: controls (C0, DEL and C1), line breaks of all kinds, marks that
/// override the direction of text.
bool is_control(char32_t code_point);

/// With a space in place of every control, and U+FFFD where there is no UTF-8 or no character.
std::string one_line(std::string_view text);

/// The same, but '\n' stays.
std::string plain_lines(std::string_view text);

}  // namespace momentscope
