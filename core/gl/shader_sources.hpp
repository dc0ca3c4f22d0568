// shader_sources.hpp -- the text of every file in shaders/, by its path there.
#pragma once
#include <map>
#include <string_view>

namespace momentscope {

const std::map<std::string_view, std::string_view>& shader_sources();

}  // namespace momentscope
