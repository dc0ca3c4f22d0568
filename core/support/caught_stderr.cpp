#include "core/support/caught_stderr.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <mutex>

namespace momentscope {

namespace {

std::mutex stderr_mutex;  // because there is only one standard error

}  // namespace

CaughtStderr::CaughtStderr() {
    stderr_mutex.lock();
#ifndef __SANITIZE_ADDRESS__
    kept_ = ::memfd_create("stderr", MFD_CLOEXEC);
    standard_ = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 0);
    if (kept_ < 0 || standard_ < 0) return;  // too many open files; then nothing is caught
    std::fflush(stderr);
    ::dup2(kept_, STDERR_FILENO);
#endif
}

CaughtStderr::~CaughtStderr() {
    if (kept_ >= 0 && standard_ >= 0) {
        std::fflush(stderr);
        ::dup2(standard_, STDERR_FILENO);
    }
    for (const int file : {kept_, standard_})
        if (file >= 0) ::close(file);
    stderr_mutex.unlock();
}

std::string CaughtStderr::first_line() const {
    std::array<char, 200> bytes{};
    const auto count = kept_ < 0 ? -1 : ::pread(kept_, bytes.data(), bytes.size(), 0);
    const std::string text(bytes.data(), static_cast<std::size_t>(std::max<decltype(count)>(count, 0)));
    return text.substr(0, text.find('\n'));
}

}  // namespace momentscope
