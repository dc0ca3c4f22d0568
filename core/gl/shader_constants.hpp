// shader_constants.hpp -- what is known about a shader before it is compiled: macros, branches of the
// preprocessor and integer constants.
#pragma once
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/gl/shader_tokens.hpp"

namespace momentscope {

/// The macros and constants at one place in a shader. Macros that a driver defines (`__VERSION__`, `GL_...`)
/// are not known; shaders do not use them.
class ShaderConstants {
public:
    /// Evaluates a #define, #undef or branch. Other directives have no effect.
    void read_directive(std::string_view line);

    /// True if the text here is compiled. Unknown conditions count as false, like undefined names in the
    /// preprocessor.
    bool active() const;

    /// Defines a name for a whole number, such as a `const int` or the variable of a loop that is written
    /// out.
    void set(std::string_view name, int value) { values_[std::string(name)] = value; }
    void forget(std::string_view name) { values_.erase(std::string(name)); }

    /// The value of an expression of whole numbers; nullopt if it depends on something that is not known
    /// here.
    std::optional<int> value_of(std::span<const ShaderToken> expression) const;

private:
    struct Branch {
        bool outer;  // is the surrounding text compiled?
        bool taken;  // has one of its parts been compiled?
        bool now;    // is the current part compiled?
    };
    bool condition(std::string_view text) const;

    std::map<std::string, std::string, std::less<>> macros_;
    std::map<std::string, int, std::less<>> values_;
    std::vector<Branch> branches_;
};

}  // namespace momentscope
