// text_encoding.hpp -- text files that are not in UTF-8.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace momentscope {

/// The text in UTF-8 when the bytes are UTF-16 (with a byte order mark, or evidently without), UTF-32 or
/// UTF-8 with such a mark. Nothing when the bytes are to be taken as they are. What is no character
/// becomes U+FFFD.
std::optional<std::string> as_utf8(std::string_view bytes);

}  // namespace momentscope
