// techniques_page.hpp -- generates docs/techniques.md from the registry.
#pragma once
#include <string>

namespace momentscope {

/// All techniques as Markdown: a table, then a paragraph and the parameters of each.
std::string techniques_page();

}  // namespace momentscope
