#include "core/support/plain_text.hpp"

namespace momentscope {

namespace {

constexpr std::string_view REPLACEMENT = "\xEF\xBF\xBD";  // U+FFFD

std::string cleaned(std::string_view text, bool line_breaks_stay) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const CodePoint one = first_code_point(text);
        if (one.value == '\n' && line_breaks_stay)
            result += '\n';
        else if (is_control(one.value))
            result += ' ';
        else if (one.value > 0x10FFFF || (one.value & 0xFFFE) == 0xFFFE)
            result += REPLACEMENT;
        else
            result += text.substr(0, one.bytes);
        text.remove_prefix(one.bytes);
    }
    return result;
}

}  // namespace

CodePoint first_code_point(std::string_view text) {
    constexpr CodePoint NONE = {NO_CODE_POINT, 1};
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(0);
    if (first < 0x80) return {first, 1};
    const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || text.size() < bytes) return NONE;
    char32_t value = first & (0x7FU >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xC0U) != 0x80) return NONE;
        value = value << 6 | (byte(i) & 0x3FU);
    }
    constexpr char32_t MIN_BY_BYTES[] = {0, 0, 0x80, 0x800,
                                         0x10000};  // smaller values have shorter encodings
    if (value < MIN_BY_BYTES[bytes] || value > 0x10FFFF || (value >= 0xD800 && value < 0xE000)) return NONE;
    return {value, bytes};
}

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const CodePoint one = first_code_point(text);
        if (one.value == NO_CODE_POINT) return false;
        text.remove_prefix(one.bytes);
    }
    return true;
}

bool is_control(char32_t c) {
    return c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0x2028 || c == 0x2029 ||
           (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
}

std::string one_line(std::string_view text) {
    return cleaned(text, false);
}

std::string plain_lines(std::string_view text) {
    return cleaned(text, true);
}

}  // namespace momentscope
