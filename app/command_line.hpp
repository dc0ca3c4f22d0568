// command_line.hpp -- runs the commands of the command line.
#pragma once

namespace momentscope {

/// Runs one command. Returns the exit code: 0, or 1 after one sentence on stderr. If Ctrl+C or SIGTERM stops
/// the work, the function does not return: it prints the sentence and ends the program by that signal.
int run_command_line(int argc, const char* const* argv);

}  // namespace momentscope
