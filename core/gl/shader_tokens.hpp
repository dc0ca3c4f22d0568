// shader_tokens.hpp -- splits the text of a shader into tokens. Joined again, they are the same text.
#pragma once
#include <string_view>
#include <vector>

namespace momentscope {

struct ShaderToken {
    /// directive: a line that begins with '#', with its line break. space: white space and comments.
    enum class Kind { word, number, sign, directive, space } kind;
    std::string_view text;

    bool is(std::string_view other) const { return text == other; }
};

/// The tokens of a text, as views of it. Signs of two characters (`<=`, `++`) are one token.
std::vector<ShaderToken> shader_tokens(std::string_view text);

}  // namespace momentscope
