// text_encoding.hpp -- reads text files that are not in UTF-8.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace momentscope {

/// The text in UTF-8, if the bytes are UTF-16 (with a byte order mark, or recognisable without), UTF-32 with
/// such a mark, or UTF-8 with such a mark. nullopt if the bytes should be used as they are. Invalid
/// characters become U+FFFD.
std::optional<std::string> as_utf8(std::string_view bytes);

}  // namespace momentscope
