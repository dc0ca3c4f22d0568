// bounded_json.hpp -- reads JSON that cannot be trusted.
#pragma once
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace momentscope {

/// Throws Error for more bytes than `most_bytes`, for deep nesting, and with the place of a syntax error.
nlohmann::json parse_bounded_json(const std::string& text, std::uintmax_t most_bytes);

}  // namespace momentscope
