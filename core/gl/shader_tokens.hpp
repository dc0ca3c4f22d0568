// shader_tokens.hpp -- the text of a shader as tokens. Joined again they are the same text.
#pragma once
#include <string_view>
#include <vector>

namespace momentscope {

struct ShaderToken {
    /// directive: a line that begins with '#', with its line break; space: white space and comments.
    enum class Kind { word, number, sign, directive, space } kind;
    std::string_view text;

    bool is(std::string_view other) const { return text == other; }
};

/// Signs of two letters (`<=`, `++`) are one token. The tokens are views of `text`.
std::vector<ShaderToken> shader_tokens(std::string_view text);

}  // namespace momentscope
