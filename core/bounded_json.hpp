// bounded_json.hpp -- reads JSON that cannot be trusted.
#pragma once
#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace momentscope {

/// What a text may ask of the reader. A value takes up to 200 bytes of memory, in whatever few letters it is
/// written, so that two million of them stay below half a GiB.
struct JsonBounds {
    std::uintmax_t bytes;            // of the text
    std::size_t values = 2'000'000;  // ten for each fragment of a ray with everything that may be said of it
    int nesting = 16;                // a session with a ray needs 5
};

/// Throws Error for more bytes, values or nesting than the bounds allow, and with the place of a syntax
/// error.
nlohmann::json parse_bounded_json(const std::string& text, const JsonBounds& bounds);

}  // namespace momentscope
