// embedded_texts.hpp -- texts that the program carries with it, by the names of their files.
#pragma once
#include <map>
#include <string_view>

namespace momentscope {

/// Every file in assets/lessons.
const std::map<std::string_view, std::string_view>& embedded_lessons();

/// docs/glossary.md as "glossary.md".
const std::map<std::string_view, std::string_view>& embedded_glossary();

}  // namespace momentscope
