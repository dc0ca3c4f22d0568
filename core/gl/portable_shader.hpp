// portable_shader.hpp -- rewrites what only some dialects have, so that all of them read the same text.
#pragma once
#include <map>
#include <string>
#include <string_view>

namespace momentscope {

/// The texture units of samplers and the numbers of uniform blocks, by name. A program gets them after it is
/// linked, because GLSL before 4.20 has no words for them.
using ShaderBindings = std::map<std::string, int, std::less<>>;

struct PortableShader {
    std::string text;
    ShaderBindings bindings;
};

/// A shader in which `layout(binding = ...)` of samplers and uniform blocks became `bindings`, and the lists
/// { ... } that initialise arrays became constructors. guards_rounding: the expression of
/// `PRECISE float x = ...;` is guarded (guarded_expression.hpp), for dialects without `precise`.
PortableShader portable_shader(std::string_view text, bool guards_rounding);

}  // namespace momentscope
