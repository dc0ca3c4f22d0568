// json_text.hpp -- writes JSON that may go to a terminal.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace momentscope {

/// The text of a JSON value with the controls escaped that JSON lets stand: it reads back the same, and a
/// terminal obeys none of it.
std::string escaped_json(std::string_view text);

/// `indent` spaces for each level, or all on one line. What is no UTF-8 becomes U+FFFD.
template <typename Json>
std::string json_text(const Json& value, int indent = -1) {
    return escaped_json(value.dump(indent, ' ', false, Json::error_handler_t::replace));
}

}  // namespace momentscope
