// end_by_signal.hpp -- Ctrl+C and similar signals end the program as usual, but leave no half-written file.
#pragma once

namespace momentscope {

/// From now on SIGINT, SIGTERM and SIGHUP first remove the unfinished file of write_file and then end the
/// program. A signal that is ignored, for instance under nohup, stays ignored.
void end_cleanly_on_signals();

/// Removes the unfinished file and ends the program by this signal, so that the waiting process sees the
/// signal. Signal handlers may call it.
[[noreturn]] void end_by_signal(int signal);

}  // namespace momentscope
