// terminal.hpp -- what the program says. Names of files and texts in them never steer the terminal.
#pragma once
#include <string_view>

namespace momentscope {

/// A line on standard error: "momentscope: " and the sentence.
void warn(std::string_view sentence);

/// The same on a file that is open, without a buffer.
void warn_to(int file, std::string_view sentence);

/// On standard output; line breaks stay.
void print(std::string_view text);

/// The program's own text, which may steer the terminal, without a buffer.
void write_raw(int file, std::string_view text);

}  // namespace momentscope
