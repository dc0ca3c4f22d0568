// command_line.hpp -- the commands of DESIGN 7.
#pragma once

namespace momentscope {

/// Runs one command. Returns the exit code: 0, or 1 after one sentence on stderr. Work that
/// Ctrl+C or SIGTERM ended does not return: the sentence is followed by that signal.
int run_command_line(int argc, const char* const* argv);

}  // namespace momentscope
