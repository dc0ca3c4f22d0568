// page_files.hpp -- the text of every file in assets/pages, by its name there: parts of the pages that charts
// and stress runs are written to.
#pragma once
#include <map>
#include <string_view>

namespace momentscope {

/// In a .html file, {name} marks where fmt inserts a text.
const std::map<std::string_view, std::string_view>& page_files();

}  // namespace momentscope
