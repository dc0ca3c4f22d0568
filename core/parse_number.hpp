// parse_number.hpp -- text that is a number from its first letter to its last.
#pragma once
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <type_traits>

namespace momentscope {

/// In decimal notation without spaces or '+', and finite; nullopt for anything else, "inf" and "nan" among
/// it, and for what T cannot hold.
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
