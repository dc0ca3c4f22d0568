// shader_constants.hpp -- what is known of a shader before it is compiled: macros, branches of the
// preprocessor and whole constants.
#pragma once
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/gl/shader_tokens.hpp"

namespace momentscope {

/// What a driver defines by itself (`__VERSION__`, `GL_...`) is not known: shaders do not ask for it.
class ShaderConstants {
public:
    /// Takes part in a #define, #undef or branch; other directives say nothing.
    void read_directive(std::string_view line);

    /// Is the text here compiled? Unknown conditions count as false, as undefined names do in the
    /// preprocessor.
    bool active() const;

    /// A name for a whole number, such as a `const int` or the variable of a loop that is written out.
    void set(std::string_view name, int value) { values_[std::string(name)] = value; }
    void forget(std::string_view name) { values_.erase(std::string(name)); }

    /// The value of an expression of whole numbers; nullopt when it depends on what is not known here.
    std::optional<int> value_of(std::span<const ShaderToken> expression) const;

private:
    struct Branch {
        bool outer;  // is the text around it compiled?
        bool taken;  // was one of its parts?
        bool now;    // is this one?
    };
    bool condition(std::string_view text) const;

    std::map<std::string, std::string, std::less<>> macros_;
    std::map<std::string, int, std::less<>> values_;
    std::vector<Branch> branches_;
};

}  // namespace momentscope
