// caught_stderr.cpp -- the console of a browser stays as it is.
#include "core/support/caught_stderr.hpp"

namespace momentscope {

CaughtStderr::CaughtStderr() = default;
CaughtStderr::~CaughtStderr() = default;

std::string CaughtStderr::first_line() const {
    return {};
}

}  // namespace momentscope
