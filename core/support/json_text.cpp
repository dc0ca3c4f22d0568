#include "core/support/json_text.hpp"

#include <fmt/format.h>

#include <iterator>

#include "core/support/plain_text.hpp"

namespace momentscope {

std::string escaped_json(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const CodePoint one = first_code_point(text);
        if (one.value >= 0x20 && is_control(one.value))  // smaller ones are only line breaks between values
            fmt::format_to(std::back_inserter(result), "\\u{:04x}", static_cast<unsigned>(one.value));
        else
            result += text.substr(0, one.bytes);
        text.remove_prefix(one.bytes);
    }
    return result;
}

}  // namespace momentscope
