// command_line_server.cpp -- runs command lines one after another, each in a forked process. A fork saves the
// half second that the dynamic loader takes. For tests/fuzz/command_lines.py and tests/faults.
//
// usage: command_line_server OUTPUT ERRORS. Both are files or devices; an empty name closes the stream. Each
// request on stdin is the number of words, a line break, and the words, each followed by a NUL. The answer is
// a line with the exit code, or minus the signal that ended the process.
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include "app/command_line.hpp"

namespace {

constexpr unsigned MAX_SECONDS = 60;

void redirect(const char* path, int to) {
    if (*path == '\0') {
        ::close(to);
        return;
    }
    const int file = ::open(path, O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (file < 0 || ::dup2(file, to) < 0) ::_exit(99);
    ::close(file);
}

[[noreturn]] void become_program(const std::vector<std::string>& words, char** files) {
    ::alarm(MAX_SECONDS);
    const int nothing = ::open("/dev/null", O_RDONLY);
    ::dup2(nothing, STDIN_FILENO);
    redirect(files[2], STDERR_FILENO);
    redirect(files[1], STDOUT_FILENO);  // last, so that a closed stream stays closed
    std::vector<const char*> arguments = {"momentscope"};
    for (const std::string& word : words) arguments.push_back(word.c_str());
    const int code = momentscope::run_command_line(static_cast<int>(arguments.size()), arguments.data());
    std::fflush(nullptr);
    ::_exit(code);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    std::size_t count = 0;
    while (std::cin >> count && std::cin.get() == '\n') {
        std::vector<std::string> words(count);
        for (std::string& word : words) std::getline(std::cin, word, '\0');
        const pid_t child = ::fork();
        if (child == 0) become_program(words, argv);
        int status = 0;
        ::waitpid(child, &status, 0);
        std::printf("%d\n", WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status));
        std::fflush(stdout);
    }
}
