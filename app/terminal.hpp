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

/// Throws Error unless all that was printed has left the program.
void require_printed();

/// To be called first. Without a standard output, as after `>&-`, the next file that is opened would take its
/// place, and what is printed would get into it; so its place is taken by what cannot be written.
void occupy_closed_streams();
/// The program's own text, which may steer the terminal, without a buffer.
void write_raw(int file, std::string_view text);

}  // namespace momentscope
