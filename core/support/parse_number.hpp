// parse_number.hpp -- reads a text that is a number as a whole.
#pragma once
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <type_traits>

namespace momentscope {

/// The number in a text. It must be finite and in decimal notation, without spaces or '+'. nullopt for
/// anything else, also for "inf" and "nan", and for numbers that T cannot hold.
template <typename T>
std::optional<T> parse_number(std::string_view text) {
    T value{};
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (status != std::errc() || end != text.data() + text.size()) return std::nullopt;
    if constexpr (std::is_floating_point_v<T>)
        if (!std::isfinite(value)) return std::nullopt;
    return value;
}

}  // namespace momentscope
