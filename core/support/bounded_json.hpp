// bounded_json.hpp -- reads JSON that may be broken or hostile.
#pragma once
#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace momentscope {

/// Limits of what a text may demand of the reader. A value takes up to 200 bytes of memory, however short its
/// text is. So two million values take less than half a GiB.
struct JsonBounds {
    std::uintmax_t bytes;            // size of the text
    std::size_t values = 2'000'000;  // a complete fragment of a ray takes ten
    int nesting = 16;                // a session with a ray needs 5
};

/// The JSON in a text. Throws Error if it exceeds the bounds, and for a syntax error, whose place is given.
nlohmann::json parse_bounded_json(const std::string& text, const JsonBounds& bounds);

}  // namespace momentscope
