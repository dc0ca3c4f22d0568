// error.hpp -- how the outside world's failures travel: one sentence, caught once at the edge.
#pragma once
#include <stdexcept>
#include <string>

#include "core/plain_text.hpp"

namespace momentscope {

/// A file, argument, shader or GL did not do what was asked. what() is one plain sentence that says
/// what is wrong and what to do; the command line prints it, the window shows it as a message.
class Error : public std::runtime_error {
public:
    explicit Error(const std::string& sentence) : std::runtime_error(one_line(sentence)) {}
};

}  // namespace momentscope
