// guarded_expression.hpp -- an expression of floats whose operations a driver cannot re-associate.
#pragma once
#include <span>
#include <string>

#include "core/gl/shader_tokens.hpp"

namespace momentscope {

/// The expression with the result of every + - * / between floats as an argument of `guarded`. Indices, and
/// arguments of conversions and of functions of bits, stay as they are. Throws Error for operators that it
/// does not know.
std::string guarded_expression(std::span<const ShaderToken> expression);

}  // namespace momentscope
