// shader_namespace.hpp -- namespaces for GLSL, which has none. The shared source may occur twice in one
// program, for the moments of the eye and for those of the light. Each copy needs its own names, as in C++.
#pragma once
#include <string>
#include <string_view>

namespace momentscope {

/// The text with the prefix `name_` before every name that it declares: functions (FN type name), structs,
/// constants (const type name) and macros. Macros that the text only tests in #if get the prefix, too, so
/// that it sees nothing of the surrounding text. Other names that the text only uses stay the same.
std::string in_namespace(std::string_view text, std::string_view name);

}  // namespace momentscope
