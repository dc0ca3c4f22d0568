// parse_number.hpp -- text that is a number from its first letter to its last.
#pragma once
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <type_traits>

namespace momentscope {

/// In decimal notation without spaces or '+'; nullopt for anything else, and for what T cannot hold. Infinity
/// and NaN pass ("inf", "nan"): only tables that the program writes itself hold such.
template <typename T>
std::optional<T> parse_any_number(std::string_view text) {
    T value{};
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (status != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// The same, and finite.
template <typename T>
std::optional<T> parse_number(std::string_view text) {
    const std::optional<T> value = parse_any_number<T>(text);
    if constexpr (std::is_floating_point_v<T>)
        if (value && !std::isfinite(*value)) return std::nullopt;
    return value;
}

}  // namespace momentscope
