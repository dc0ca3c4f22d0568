// plain_text.hpp -- makes text from outside safe to show. File names and texts in files may contain control
// codes, which a terminal obeys, and bytes that are not text.
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

/// The first code point of a text that is not empty. NO_CODE_POINT, with a length of one byte, if it is not
/// UTF-8.
CodePoint first_code_point(std::string_view text);

bool is_utf8(std::string_view text);

/// True for code points that affect the text around them: controls (C0, DEL and C1), all kinds of line
/// breaks, and marks that override the direction of text.
bool is_control(char32_t code_point);

/// The text with every control replaced by a space, and with U+FFFD instead of bytes that are not UTF-8 and
/// code points that are not characters.
std::string one_line(std::string_view text);

/// The same, but '\n' is kept.
std::string plain_lines(std::string_view text);

}  // namespace momentscope
