// command_line_files_test.cpp -- how commands treat files: nothing is lost, and failures are reported.
#include "app/end_by_signal.hpp"
#include "core/support/output_file.hpp"
#include "tests/unit/command_line_fixture.hpp"

#include <sys/resource.h>
#include <csignal>

using namespace momentscope;
using namespace momentscope::test;

namespace {

class CommandLineFiles : public CommandLine {
protected:
    void expect_said(const Outcome& outcome, const std::string& part) const {
        EXPECT_TRUE(outcome.exited);
        EXPECT_EQ(outcome.code, 1);
        EXPECT_NE(outcome.errors.find(part), std::string::npos) << outcome.errors;
    }
    long files_beside(const fs::path& path) const {
        return std::distance(fs::directory_iterator(path.parent_path()), {}) - 1;
    }
};

// Commands that print without OpenGL; tests/faults/full_disk.py has all commands.
constexpr const char* PRINTING[] = {"--help",
                                    "stress --help",
                                    "list commands",
                                    "list techniques --format json",
                                    "inspect --ray ray.json",
                                    "stress --rays 1 --technique power4-32 --condition two",
                                    "tune --ray ray.json --technique power4-32"};

TEST_F(CommandLineFiles, WhatCannotBePrintedIsAFailure) {
    const auto full = [] { redirect("/dev/full", O_WRONLY, STDOUT_FILENO); };
    const auto closed = [] { ::close(STDOUT_FILENO); };
    for (const char* line : PRINTING) {
        expect_said(run_words(words_of(line), full), "Standard output could not be written");
        expect_said(run_words(words_of(line), closed), "Standard output could not be written");
    }
}

// An opened file gets the lowest free number, which could be that of standard output.
TEST_F(CommandLineFiles, WhatIsPrintedGetsIntoNoFile) {
    const auto closed = [] {
        ::close(STDIN_FILENO);
        ::close(STDOUT_FILENO);
    };
    const std::string stress = "stress --rays 1 --technique power4-32 --condition two -o ";
    expect_said(run_words(words_of(stress + "out/x.csv"), closed), "Standard output could not be written");
    expect_success(stress + "out/y.csv");
    EXPECT_EQ(content_of(folder_ / "out/x.csv"), content_of(folder_ / "out/y.csv"));
}

TEST_F(CommandLineFiles, ASignalRemovesWhatIsHalfWritten) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        write("out/a.txt", "old");
        const pid_t child = ::fork();
        if (child == 0) {
            static int sent = 0;
            sent = signal;
            end_cleanly_on_signals();
            std::signal(SIGXFSZ, [](int) { ::raise(sent); });  // SIGXFSZ comes when the first half is written
            const rlimit half = {500, 500};
            ::setrlimit(RLIMIT_FSIZE, &half);
            write_file(std::string(1000, 'x'), folder_ / "out/a.txt");
            ::_exit(0);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        EXPECT_TRUE(WIFSIGNALED(status));
        EXPECT_EQ(WTERMSIG(status), signal);
        EXPECT_EQ(content_of(folder_ / "out/a.txt"), "old");
        EXPECT_EQ(files_beside(folder_ / "out/a.txt"), 0);
    }
}

TEST_F(CommandLineFiles, AnIgnoredSignalStaysIgnored) {
    const Outcome outcome = run_words({"list", "scenes"}, [] {
        std::signal(SIGHUP, SIG_IGN);
        end_cleanly_on_signals();
        ::raise(SIGHUP);
    });
    EXPECT_EQ(outcome.code, 0);
    EXPECT_TRUE(outcome.exited);
}

TEST_F(CommandLineFiles, AReadOnlyFolderIsSaidBeforeTheWork) {
    fs::create_directories(folder_ / "locked");
    write("locked/old.png", "old");
    fs::permissions(folder_ / "locked/old.png", fs::perms::all);
    fs::permissions(folder_ / "locked", fs::perms(0555));
    fs::permissions(folder_ / "out", fs::perms::all);
    const auto as_nobody = [] {
        constexpr uid_t NOBODY = 65534;
        if (::getuid() == 0 && ::setuid(NOBODY) != 0) ::_exit(99);
    };
    for (const char* name : {"new.png", "old.png"})
        expect_words_refused({"render", "--scene", "nowhere", "-o", std::string("locked/") + name},
                             "cannot be written in the folder 'locked'", as_nobody);
    fs::permissions(folder_ / "locked", fs::perms::owner_all);
}

TEST_F(CommandLineFiles, WhatACommandReadsItDoesNotReplace) {
    const std::string ray = content_of(folder_ / "ray.json");
    fs::create_hard_link(folder_ / "ray.json", folder_ / "same.json");
    fs::create_symlink("ray.json", folder_ / "link.json");
    write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const char* lost = "is read by this command";
    for (const char* name : {"ray.json", "./ray.json", "out/../ray.json", "same.json", "link.json"}) {
        expect_refused(std::string("inspect --ray ray.json -o ") + name, lost);
        expect_refused(std::string("--headless --screenshot out/x.png --ray ray.json --log ") + name, lost);
    }
    expect_refused("inspect --scene m.obj -o m.obj", lost);
    expect_refused("--headless --events e.png --screenshot e.png", lost);
    expect_refused("--headless --session s.png --screenshot s.png", lost);
    expect_refused("compare a.png wboit --metric rmse -o ./a.png", lost);
    expect_refused("merge a.csv b.csv -o b.csv", lost);
    expect_refused("--headless --screenshot out/x.png --log out/x.png", "are the same file");
    EXPECT_EQ(content_of(folder_ / "ray.json"), ray);
}

TEST_F(CommandLineFiles, ALogStaysUntilARunWentWell) {
    write("log.txt", "old");
    write("wrong.json", "[");
    const std::string window = "--headless --screenshot out/x.png --log log.txt ";
    expect_refused(window + "--session wrong.json", "JSON");
    expect_refused(window + "--ray wrong.json", "JSON");
    write("broken.obj", "v 0 0 zero\nf 1 2 3\n");
    for (const char* mesh : {"missing.obj", "broken.obj"})
        expect_refused(window + "--size 640x400 --scene " + mesh, mesh);
    write("x.events", "key L\nexpect /scene none\n");
    expect_refused("--headless --size 640x400 --log log.txt --events x.events", "none");
    EXPECT_EQ(content_of(folder_ / "log.txt"), "old");
    expect_success("--headless --size 640x400 --log log.txt --screenshot out/x.png");
    EXPECT_TRUE(content_of(folder_ / "log.txt").starts_with("frame 1: "));
}

TEST_F(CommandLineFiles, ScreenshotsOfEventsReplacePicturesAlone) {
    write("note.txt", "precious");
    fs::create_hard_link(folder_ / "ray.json", folder_ / "ray.png");
    const std::string ray = content_of(folder_ / "ray.json");
    const std::string window = "--headless --size 640x400 --ray ray.png --events ";
    for (const auto& [event, said] :
         {std::pair("screenshot note.txt", "is a .png"), std::pair("screenshot x.exr", "is a .png"),
          std::pair("screenshot ray.json", "is a .png"),
          std::pair("screenshot ./ray.png", "already used by this command line")}) {
        write("x.events", event);
        expect_refused(window + "x.events", said);
    }
    EXPECT_EQ(content_of(folder_ / "note.txt"), "precious");
    EXPECT_EQ(content_of(folder_ / "ray.json"), ray);
}

// The same name, but another mesh: the rows of the first mesh must not be used.
TEST_F(CommandLineFiles, AChartGoesOnWithTheSameMeshAlone) {
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const std::string chart = "chart --scene m.obj --size 16x9 --repeat 1 --technique wboit -o ";
    write("m.obj", triangle);
    expect_success(chart + "x.csv");
    fs::copy(folder_ / "x.csv", folder_ / "y.csv.partial");
    expect_success(chart + "y.csv");
    EXPECT_EQ(content_of(folder_ / "y.csv"), content_of(folder_ / "x.csv")) << "rows were kept";
    fs::copy(folder_ / "x.csv", folder_ / "z.csv.partial");
    write("m.obj", triangle + "v 0 0 1\nf 1 2 4\n");
    expect_refused(chart + "z.csv", "its mesh content is ");
    EXPECT_EQ(content_of(folder_ / "z.csv.partial"), content_of(folder_ / "x.csv"));
    expect_refused("advise --scene m.obj --chart x.csv --max-error 0.9", "has changed since 'x.csv'");
}

}  // namespace
