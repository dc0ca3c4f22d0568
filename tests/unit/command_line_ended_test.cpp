// command_line_ended_test.cpp -- Ctrl+C: every command reacts soon, says what is kept, and leaves neither a
// process nor a half-written file.
#include "app/progress.hpp"
#include "core/support/output_file.hpp"
#include "tests/unit/command_line_fixture.hpp"

#include <chrono>
#include <csignal>
#include <thread>

namespace momentscope::test {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds GENEROUS{20};  // for a busy machine; an idle one needs less than a second

template <typename Condition>
bool comes_true(const Condition& condition) {
    for (const Clock::time_point begin = Clock::now(); Clock::now() - begin < GENEROUS;) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

class EndedCommandLine : public CommandLine {
protected:
    /// Interrupts a process as soon as `ready` returns true, and returns the outcome.
    template <typename Ready>
    Outcome interrupted(const std::function<void()>& process, const Ready& ready) const {
        std::fflush(nullptr);
        const pid_t child = ::fork();
        if (child == 0) {
            process();
            ::_exit(98);
        }
        EXPECT_TRUE(comes_true([&] { return ready(child); })) << "it did not begin";
        ::kill(child, SIGINT);
        int status = 0;
        EXPECT_TRUE(comes_true([&] { return ::waitpid(child, &status, WNOHANG) == child; })) << "it goes on";
        return {WIFEXITED(status), WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status),
                content_of(folder_ / "stdout.txt"), content_of(folder_ / "stderr.txt")};
    }

    /// Runs in a forked process with its own folder and ends the process after a minute.
    void begin() const {
        ::alarm(60);
        if (::chdir(folder_.c_str()) != 0) ::_exit(99);
        redirect("stderr.txt", O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
        redirect("stdout.txt", O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
    }

    bool has(const char* name) const { return fs::exists(folder_ / name); }
};

std::string child_of(pid_t process) {
    return content_of(fmt::format("/proc/{0}/task/{0}/children", process));
}

// The parent may not have collected its exit status yet.
bool is_gone(const std::string& process) {
    const std::string stat = content_of(fmt::format("/proc/{}/stat", std::stoi(process)));
    return stat.empty() || stat.find(") Z ") != std::string::npos;
}

// Assimp never finishes reading this file, because its header does not end.
TEST_F(EndedCommandLine, WhileAMeshIsRead) {
    write("endless.ply", "ply\nformat ascii 1.0\nelement vertex 3\n");
    for (const char* line :
         {"chart --technique wboit --size 16x9 -o out/a.csv", "chart --shadows --size 16x9 -o out/a.csv",
          "advise --max-error 0.1", "needed -o out/a.png", "tune", "render -o out/a.png",
          "inspect -o out/a.json", "compare sorted wboit --metric rmse -o out/a.png"}) {
        SCOPED_TRACE(line);
        std::string reader;
        const Outcome outcome = interrupted(
            [&] { become_program(folder_, words_of(std::string(line) + " --scene endless.ply"), nullptr); },
            [&](pid_t process) { return !(reader = child_of(process)).empty(); });
        EXPECT_EQ(outcome.code, -SIGINT) << "whoever started it sees what ended it";
        EXPECT_NE(outcome.errors.find("was stopped before"), std::string::npos) << outcome.errors;
        EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
        EXPECT_TRUE(fs::is_empty(folder_ / "out"));
        EXPECT_TRUE(comes_true([&] { return is_gone(reader); })) << "its reader lives on";
    }
}

// Work that does not check the token, such as a GL that draws.
TEST_F(EndedCommandLine, WorkThatDoesNotStopIsCutOff) {
    const Outcome outcome = interrupted(
        [&] {
            begin();
            const Progress progress("Work", [] { return "Three rows are kept."; });
            write_file("", "begun");
            for (;;) ::pause();
        },
        [&](pid_t) { return has("begun"); });
    EXPECT_EQ(outcome.code, -SIGINT);
    EXPECT_EQ(outcome.errors, "momentscope: Three rows are kept.\n");
}

TEST_F(EndedCommandLine, WorkThatStopsHasTheLastWord) {
    const Outcome outcome = interrupted(
        [&] {
            begin();
            const Progress progress("Work");
            write_file("", "begun");
            while (!progress.stop().stop_requested()) ::usleep(1000);
            try {
                progress.require_finished();
            } catch (const Error& error) {
                std::puts(error.what());
            }
            std::fflush(nullptr);
            ::_exit(7);
        },
        [&](pid_t) { return has("begun"); });
    EXPECT_EQ(outcome.code, 7);
    EXPECT_EQ(outcome.output, "Work was stopped before it was finished; nothing was written.\n");
}

TEST_F(EndedCommandLine, AFileThatIsBeingWrittenIsWritten) {
    const Outcome outcome = interrupted(
        [&] {
            begin();
            const Progress progress("Work");
            {
                const FileWriting now;
                std::ofstream file("out/a.txt");
                file << "one half, " << std::flush;
                std::ofstream("begun") << std::flush;
                std::this_thread::sleep_for(3 * Progress::PATIENCE);
                file << "the other" << std::flush;
            }
            for (;;) ::pause();
        },
        [&](pid_t) { return has("begun"); });
    EXPECT_EQ(outcome.code, -SIGINT);
    EXPECT_EQ(content_of(folder_ / "out/a.txt"), "one half, the other");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "out"), fs::directory_iterator()), 1);
}

}  // namespace
}  // namespace momentscope::test
