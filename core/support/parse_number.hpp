// parse_number.hpp -- reads a text that is a number as a whole.
#pragma once
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <type_traits>

#include "core/support/real_from_chars.hpp"

namespace momentscope {

/// The number in a text. It must be finite and in decimal notation, without spaces or '+'. nullopt for
/// anything else, also for "inf" and "nan", and for numbers that T cannot hold.
template <typename T>
std::optional<T> parse_number(std::string_view text) {
    T value{};
    std::from_chars_result read{};
    if constexpr (std::is_floating_point_v<T>)
        read = real_from_chars(text, value);
    else
        read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
    if constexpr (std::is_floating_point_v<T>)
        if (!std::isfinite(value)) return std::nullopt;
    return value;
}

}  // namespace momentscope
