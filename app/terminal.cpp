#include "app/terminal.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>

#include "core/support/error.hpp"
#include "core/support/plain_text.hpp"

namespace momentscope {

namespace {

std::string warning_line(std::string_view sentence) {
    return "momentscope: " + one_line(sentence) + "\n";
}

}  // namespace

void warn(std::string_view sentence) {
    std::fputs(warning_line(sentence).c_str(), stderr);
}

void warn_to(int file, std::string_view sentence) {
    write_raw(file, warning_line(sentence));
}

void print(std::string_view text) {
    const std::string plain = plain_lines(text);
    std::fwrite(plain.data(), 1, plain.size(), stdout);
}

void require_printed() {
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
        throw Error("Standard output could not be written; free some space, or send it elsewhere.");
}

void occupy_closed_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(stream, F_GETFD) < 0)
            ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);  // takes the lowest number
}

void write_raw(int file, std::string_view text) {
    while (!text.empty()) {
        const auto written = ::write(file, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

}  // namespace momentscope
