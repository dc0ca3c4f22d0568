// terminal.hpp -- all output of the program. Control characters in names and texts never reach the terminal.
#pragma once
#include <string_view>

namespace momentscope {

/// Prints a line on standard error: "momentscope: " and the sentence.
void warn(std::string_view sentence);

/// The same on an open file, unbuffered.
void warn_to(int file, std::string_view sentence);

/// Prints on standard output; line breaks are kept.
void print(std::string_view text);

/// Throws Error unless all printed text was written.
void require_printed();

/// Call this first. If standard output is closed, as after `>&-`, the next opened file would take its number,
/// and printed text would end up in that file. So this fills the number with a file that cannot be written.
void occupy_closed_streams();
/// Writes text of the program itself, which may contain control codes, unbuffered.
void write_raw(int file, std::string_view text);

}  // namespace momentscope
