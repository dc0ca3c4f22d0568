#include "app/terminal.hpp"

#include <cstdio>
#include <string>

#include "core/plain_text.hpp"

namespace momentscope {

void warn(std::string_view sentence) {
    std::fputs(("momentscope: " + one_line(sentence) + "\n").c_str(), stderr);
}

void print(std::string_view text) {
    const std::string plain = plain_lines(text);
    std::fwrite(plain.data(), 1, plain.size(), stdout);
}

}  // namespace momentscope
