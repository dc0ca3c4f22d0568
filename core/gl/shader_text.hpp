// shader_text.hpp -- the text of a shader in any dialect, from the files of shaders/.
#pragma once
#include <compare>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/gl/dialect.hpp"
#include "core/gl/portable_shader.hpp"

namespace momentscope {

/// A technique in a namespace of its own: what `#include "technique"` means between `#namespace name` and
/// `#endnamespace`, and #defines that are only seen there.
struct ShaderNamespace {
    std::map<std::string, std::string> defines;
    std::string technique = {};
    std::string constants = {};
    friend auto operator<=>(const ShaderNamespace&, const ShaderNamespace&) = default;
};

/// A variant of a shader: #defines, and what `#include "technique"` means.
struct ShaderVariant {
    std::map<std::string, std::string> defines;
    std::string technique = {};                              // a path in shaders/, or empty
    std::string constants = {};                              // declarations before the technique
    std::map<std::string, ShaderNamespace> namespaces = {};  // by name; text in others is left out

    friend auto operator<=>(const ShaderVariant&, const ShaderVariant&) = default;
};

struct ShaderText {
    std::string text;                // with its loops written out (loop_writer.hpp)
    std::string with_loops;          // with its loops as they are; empty if there are none to write out
    std::vector<std::string> files;  // #line directives give each file its number here
    ShaderBindings bindings;
    int loops_left = 0;  // loops marked UNROLL that could not be written out
};

/// The whole text of a shader: version, defines, prelude, and the file with its #includes joined. Throws
/// Error for an unknown file.
ShaderText shader_text(std::string_view path, const ShaderVariant& variant, ShaderLanguage language);

}  // namespace momentscope
