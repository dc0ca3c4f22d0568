// json_text.hpp -- writes JSON that is safe on a terminal.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace momentscope {

/// The text of a JSON value with those control characters escaped that JSON allows. It reads back the same,
/// and contains nothing that a terminal obeys.
std::string escaped_json(std::string_view text);

/// A JSON value as text, with `indent` spaces per level, or on one line. Bytes that are not UTF-8 become
/// U+FFFD.
template <typename Json>
std::string json_text(const Json& value, int indent = -1) {
    return escaped_json(value.dump(indent, ' ', false, Json::error_handler_t::replace));
}

}  // namespace momentscope
