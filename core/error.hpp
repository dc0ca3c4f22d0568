// error.hpp -- how the outside world's failures travel: one sentence, caught once at the edge.
#pragma once
#include <stdexcept>
#include <string>
#include <utility>

namespace momentscope {

/// A file, argument, shader or GL did not do what was asked. what() is one plain sentence that says
/// what is wrong and what to do; the command line prints it, the window shows it as a message.
class Error : public std::runtime_error {
public:
    explicit Error(std::string sentence) : std::runtime_error(on_one_line(std::move(sentence))) {}

private:
    // Names from outside may hold line breaks and terminal codes.
    static std::string on_one_line(std::string text) {
        for (char& c : text)
            if (static_cast<unsigned char>(c) < ' ' || c == 127) c = ' ';
        return text;
    }
};

}  // namespace momentscope
