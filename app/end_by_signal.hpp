// end_by_signal.hpp -- Ctrl+C and the like end the program as ever, but leave no half-written file behind.
#pragma once

namespace momentscope {

/// From now on SIGINT, SIGTERM and SIGHUP remove what write_file has begun before they end the program. One
/// that is ignored, as under nohup, stays so.
void end_cleanly_on_signals();

/// Removes it and ends the program by that signal, which is what whoever waits for it sees. Handlers of
/// signals may call it.
[[noreturn]] void end_by_signal(int signal);

}  // namespace momentscope
