// command_line_fixture.hpp -- runs the program in a forked process, which saves the quarter of a second that
// the dynamic loader takes. Code that starts threads, such as drawing, must run in a forked process, not in
// this one.
#pragma once
#include "app/command_line.hpp"
#include "core/image/image.hpp"
#include "tests/unit/expect_error.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>
#include <wordexp.h>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace momentscope::test {

namespace fs = std::filesystem;

inline std::string content_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

struct Outcome {
    bool exited = false;  // it was not killed by a signal
    int code = 0;
    std::string output;
    std::string errors;
};

/// The words of a line, with quotes as in a shell.
inline std::vector<std::string> words_of(const std::string& line) {
    wordexp_t words{};
    if (::wordexp(line.c_str(), &words, WRDE_NOCMD) != 0) throw std::invalid_argument(line);
    std::vector<std::string> all(words.we_wordv, words.we_wordv + words.we_wordc);
    ::wordfree(&words);
    return all;
}

inline void redirect(const char* path, int flags, int to) {
    const int file = ::open(path, flags, 0644);
    if (file < 0 || ::dup2(file, to) < 0) ::_exit(99);
}

/// The code of a forked process: runs the program and writes its output to files of the folder. `prepare`
/// changes the process before. The process ends after a minute.
[[noreturn]] inline void become_program(const fs::path& folder, std::vector<std::string> words,
                                        const std::function<void()>& prepare) {
    ::alarm(60);
    if (::chdir(folder.c_str()) != 0) ::_exit(99);
    redirect("/dev/null", O_RDONLY, STDIN_FILENO);
    redirect("stdout.txt", O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
    redirect("stderr.txt", O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
    if (prepare) prepare();
    words.insert(words.begin(), "momentscope");
    std::vector<const char*> arguments;
    for (const std::string& word : words) arguments.push_back(word.c_str());
    const int code = run_command_line(static_cast<int>(arguments.size()), arguments.data());
    std::fflush(nullptr);
    ::_exit(code);
}

/// Runs the program in a temporary folder. It may write only to the subfolder `out`. There is no display.
class CommandLine : public testing::Test {
protected:
    CommandLine() : folder_(fs::temp_directory_path() / ("momentscope_line_" + std::to_string(::getpid()))) {
        fs::create_directories(folder_ / "out");
        ::unsetenv("DISPLAY");
        ::unsetenv("WAYLAND_DISPLAY");
        write("ray.json",
              R"({"fragments": [{"depth": 0.5, "opacity": 0.75}, {"depth": -0.5, "opacity": 0.5}]})");
    }
    ~CommandLine() override {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }

    void write(const std::string& name, const std::string& content) const {
        std::ofstream(folder_ / name, std::ios::binary) << content;
    }

    void write_picture(const Image& picture, const char* name) const {
        const pid_t child = ::fork();
        if (child == 0) {
            write_image(picture, folder_ / name);
            ::_exit(0);
        }
        ::waitpid(child, nullptr, 0);
    }

    Outcome run(const std::string& arguments) const { return run_words(words_of(arguments)); }

    Outcome run_words(const std::vector<std::string>& words,
                      const std::function<void()>& prepare = nullptr) const {
        std::fflush(nullptr);
        const pid_t child = ::fork();
        if (child == 0) become_program(folder_, words, prepare);
        int status = 0;
        ::waitpid(child, &status, 0);
        return {WIFEXITED(status), WEXITSTATUS(status), content_of(folder_ / "stdout.txt"),
                content_of(folder_ / "stderr.txt")};
    }

    /// Expects one line on stderr that contains `part`, nothing on stdout, exit code 1, and no file.
    void expect_refused(const std::string& arguments, const std::string& part) {
        expect_words_refused(words_of(arguments), part);
    }

    void expect_words_refused(const std::vector<std::string>& words, const std::string& part,
                              const std::function<void()>& prepare = nullptr) {
        SCOPED_TRACE(fmt::format("{}", fmt::join(words, " ")));
        const Outcome outcome = run_words(words, prepare);
        EXPECT_TRUE(outcome.exited);
        EXPECT_EQ(outcome.code, 1);  // neither 124 (hung) nor 128 + a signal
        EXPECT_EQ(outcome.output, "");
        ASSERT_TRUE(outcome.errors.starts_with("momentscope: ")) << outcome.errors;
        ASSERT_EQ(outcome.errors.back(), '\n');
        expect_one_sentence(outcome.errors.substr(13, outcome.errors.size() - 14));
        EXPECT_NE(outcome.errors.find(part), std::string::npos) << outcome.errors;
        EXPECT_TRUE(fs::is_empty(folder_ / "out")) << fs::directory_iterator(folder_ / "out")->path();
    }

    void expect_all_refused(const std::string& before, const std::vector<std::string>& wrong,
                            const std::string& part) {
        for (const std::string& value : wrong) expect_refused(before + value + " -o out/x", part);
    }

    Outcome expect_success(const std::string& arguments) const {
        return expect_words_succeed(words_of(arguments));
    }

    Outcome expect_words_succeed(const std::vector<std::string>& words,
                                 const std::function<void()>& prepare = nullptr) const {
        Outcome outcome = run_words(words, prepare);
        EXPECT_EQ(outcome.code, 0) << fmt::format("{}", fmt::join(words, " "));
        EXPECT_EQ(outcome.errors, "") << fmt::format("{}", fmt::join(words, " "));
        return outcome;
    }

    fs::path folder_;
};

}  // namespace momentscope::test
