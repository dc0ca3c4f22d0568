// text_encoding.cpp -- converts UTF-16 and UTF-32 to UTF-8 and removes byte order marks.
#include "core/scene/text_encoding.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace momentscope {
namespace {

struct Encoding {
    std::size_t unit = 1;  // bytes
    bool big_endian = false;
    std::size_t mark = 0;  // bytes of the byte order mark
};

struct Mark {
    std::string_view bytes;
    Encoding encoding;
};

using namespace std::string_view_literals;
// UTF-32 comes first, because its mark begins with that of UTF-16.
constexpr std::array<Mark, 5> MARKS = {{{"\xff\xfe\0\0"sv, {4, false, 4}},
                                        {"\0\0\xfe\xff"sv, {4, true, 4}},
                                        {"\xff\xfe"sv, {2, false, 2}},
                                        {"\xfe\xff"sv, {2, true, 2}},
                                        {"\xef\xbb\xbf"sv, {1, false, 3}}}};

/// True if every second byte of the beginning is zero and the others are plain text. No binary format begins
/// like this.
bool alternates(std::string_view bytes, std::size_t zeros) {
    const std::size_t count = std::min(bytes.size() / 2, std::size_t{64});
    if (count < 8) return false;
    for (std::size_t i = 0; i < count; ++i) {
        const char text = bytes[2 * i + 1 - zeros];
        if (bytes[2 * i + zeros] != 0) return false;
        if (!(text >= ' ' && text < 127) && text != '\t' && text != '\r' && text != '\n') return false;
    }
    return true;
}

std::optional<Encoding> encoding_of(std::string_view bytes) {
    for (const Mark& mark : MARKS)
        if (bytes.starts_with(mark.bytes)) return mark.encoding;
    if (alternates(bytes, 1)) return Encoding{2, false, 0};
    if (alternates(bytes, 0)) return Encoding{2, true, 0};
    return std::nullopt;
}

void append_utf8(std::string& text, std::uint32_t c) {
    if (c > 0x10ffff || (c >= 0xd800 && c < 0xe000)) c = 0xfffd;
    const auto add = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
    const auto add_rest = [&](unsigned shift) { add(0x80 | ((c >> shift) & 0x3f)); };
    if (c < 0x80) return add(c);
    if (c < 0x800) {
        add(0xc0 | (c >> 6));
    } else if (c < 0x10000) {
        add(0xe0 | (c >> 12));
        add_rest(6);
    } else {
        add(0xf0 | (c >> 18));
        add_rest(12);
        add_rest(6);
    }
    add_rest(0);
}

}  // namespace

std::optional<std::string> as_utf8(std::string_view bytes) {
    const std::optional<Encoding> encoding = encoding_of(bytes);
    if (!encoding) return std::nullopt;
    bytes.remove_prefix(encoding->mark);
    if (encoding->unit == 1) return std::string(bytes);

    const std::size_t count = bytes.size() / encoding->unit;
    const auto unit_at = [&](std::size_t i) {
        std::uint32_t unit = 0;
        for (std::size_t b = 0; b < encoding->unit; ++b) {
            const std::size_t place = encoding->big_endian ? b : encoding->unit - 1 - b;
            unit = (unit << 8) | static_cast<unsigned char>(bytes[i * encoding->unit + place]);
        }
        return unit;
    };
    std::string text;
    text.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::uint32_t c = unit_at(i);
        const bool first_half = encoding->unit == 2 && c >= 0xd800 && c < 0xdc00;
        if (first_half && i + 1 < count) {
            const std::uint32_t second = unit_at(i + 1);
            if (second >= 0xdc00 && second < 0xe000) {
                c = 0x10000 + ((c - 0xd800) << 10) + (second - 0xdc00);
                ++i;
            }
        }
        append_utf8(text, c);
    }
    return text;
}

}  // namespace momentscope
