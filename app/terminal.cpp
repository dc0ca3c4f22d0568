#include "app/terminal.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>

#include "core/plain_text.hpp"

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

void write_raw(int file, std::string_view text) {
    while (!text.empty()) {
        const auto written = ::write(file, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

}  // namespace momentscope
