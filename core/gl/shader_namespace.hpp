// shader_namespace.hpp -- namespaces for GLSL, which has none: the shared source may stand in one program
// twice, as for the moments of the eye and those of the light, and each has its own names, as in C++.
#pragma once
#include <string>
#include <string_view>

namespace momentscope {

/// The text with `name_` before every name that it declares: functions (FN type name), structs, constants
/// (const type name) and macros, also such as it only asks for in #if, so that none of the surrounding text
/// is seen. What it only uses stays.
std::string in_namespace(std::string_view text, std::string_view name);

}  // namespace momentscope
