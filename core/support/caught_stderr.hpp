// caught_stderr.hpp -- catches what libraries print on standard error.
#pragma once
#include <string>

namespace momentscope {

/// During its life, everything that the process writes to standard error is caught. Only one exists at a
/// time; other threads wait for it. With AddressSanitizer nothing is caught, because its reports must be
/// seen.
class CaughtStderr {
public:
    CaughtStderr();
    ~CaughtStderr();
    CaughtStderr(const CaughtStderr&) = delete;
    CaughtStderr& operator=(const CaughtStderr&) = delete;

    /// The first line that was caught.
    std::string first_line() const;

private:
    [[maybe_unused]] int kept_ = -1;      // a file in memory
    [[maybe_unused]] int standard_ = -1;  // the original target of standard error
};

}  // namespace momentscope
