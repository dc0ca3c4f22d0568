// caught_stderr.hpp -- what libraries print on standard error by themselves.
#pragma once
#include <string>

namespace momentscope {

/// While it lives, what anything in the process writes to standard error is kept instead. One lives at a
/// time; another thread waits for it. With AddressSanitizer, whose reports must be seen, nothing is caught.
class CaughtStderr {
public:
    CaughtStderr();
    ~CaughtStderr();
    CaughtStderr(const CaughtStderr&) = delete;
    CaughtStderr& operator=(const CaughtStderr&) = delete;

    /// The first line of it.
    std::string first_line() const;

private:
    int kept_ = -1;      // a file in memory
    int standard_ = -1;  // where standard error went before
};

}  // namespace momentscope
