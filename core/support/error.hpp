// error.hpp -- the exception for failures from outside: one sentence, caught in one place.
#pragma once
#include <stdexcept>
#include <string>

#include "core/support/plain_text.hpp"

namespace momentscope {

/// A failure of a file, an argument, a shader or the GL. what() is one plain sentence that says what is wrong
/// and what to do. The command line prints it; the window shows it as a message.
class Error : public std::runtime_error {
public:
    explicit Error(const std::string& sentence) : std::runtime_error(one_line(sentence)) {}
};

}  // namespace momentscope
