// command_line_names_test.cpp -- difficult names: too long, not UTF-8, with line breaks, commas or terminal
// codes; folders that are closed or gone; libraries that crash.
#include "core/support/plain_text.hpp"
#include "tests/unit/command_line_fixture.hpp"

#include <sys/resource.h>
#include <sys/stat.h>
#include <algorithm>
#include <nlohmann/json.hpp>

using namespace momentscope;
using namespace momentscope::test;

namespace {

using nlohmann::json;

class CommandLineNames : public CommandLine {
protected:
    static constexpr const char* TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

    // The output is text, and its only control characters are line breaks.
    static void expect_plain(const std::string& text) {
        EXPECT_TRUE(is_utf8(text));
        EXPECT_EQ(plain_lines(text), text);
    }
};

TEST_F(CommandLineNames, TooLongOnesAreNamed) {
    const std::string longest(300, 'a');
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"render", "--scene", "planes", "-o", "out/" + longest + ".png"},
             {"inspect", "--scene", longest},
             {"inspect", "--ray", longest},
             {"inspect", "--ray", "ray.json", "-o", longest},
             {"chart", "--size", "16x9", "--scene", longest},
             {"chart", "--size", "16x9", "--scene", "planes", "-o", "out/" + longest + ".csv"},
             {"merge", longest, "-o", "out/x.csv"},
             {"compare", longest, longest},
             {"advise", "--max-error", "1", "--scene", "planes", "--chart", longest},
             {"explore", "--headless", "--screenshot", "out/x.png", "--session", longest},
             {"explore", "--headless", "--screenshot", "out/x.png", "--log", "out/" + longest}})
        expect_words_refused(words, "too long");
}

TEST_F(CommandLineNames, TheLongestOnesAreWritten) {
    const std::string name(250, 'b');
    expect_words_succeed({"inspect", "--ray", "ray.json", "--depths=0", "-o", "out/" + name + ".json"});
    EXPECT_GT(fs::file_size(folder_ / "out" / (name + ".json")), 100U);
    expect_words_succeed({"chart", "--scene", "planes", "--size", "16x9", "--technique", "wboit", "--repeat",
                          "1", "-o", "out/" + name + ".csv"});
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "out"), {}), 2) << "no unfinished chart is left";
}

TEST_F(CommandLineNames, ClosedFoldersAreNamed) {
    fs::create_directories(folder_ / "closed");
    write("closed/x.obj", TRIANGLE);
    fs::permissions(folder_ / "closed", fs::perms::none);
    const auto as_nobody = [] {
        constexpr uid_t NOBODY = 65534;
        if (::getuid() == 0 && ::setuid(NOBODY) != 0) ::_exit(99);
    };
    fs::permissions(folder_ / "out", fs::perms::all);
    for (const char* line : {"inspect --scene closed/x.obj", "chart --size 16x9 --scene closed/x.obj",
                             "inspect --ray closed/ray.json", "render --scene planes -o closed/x.png",
                             "merge closed/x.csv -o out/x.csv", "compare closed/x.png closed/y.png",
                             "--headless --screenshot closed/x.png"})
        expect_words_refused(words_of(line), "may not enter", as_nobody);
    fs::permissions(folder_ / "closed", fs::perms::owner_all);
}

TEST_F(CommandLineNames, AWorkingFolderThatIsGoneIsNamed) {
    const auto leave = [] {
        ::mkdir("gone", 0755);
        if (::chdir("gone") != 0 || ::rmdir("../gone") != 0) ::_exit(99);
    };
    for (const char* line :
         {"figure fig3", "inspect --scene planes -o x.json", "render --scene planes -o x.png"})
        expect_words_refused(words_of(line), "working folder is gone", leave);
    expect_words_succeed(
        {"--headless", "--scene", "planes", "--size", "640x400", "--screenshot", folder_ / "window.png"},
        leave);  // its file dialog starts there
}

// The name contains text, terminal codes and a byte that is not UTF-8.
const std::string CODES = "\x1B[31m\x07\x7F\u009B31m";

TEST_F(CommandLineNames, CodesOfTerminalsReachNone) {
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"--" + CODES},
                                               {"list", CODES},
                                               {"inspect", "--scene", CODES},
                                               {"inspect", "--scene", "nor\xE9" + CODES},
                                               {"inspect", "--ray", "ray.json", "--technique", CODES}}) {
        expect_words_refused(words, " 31m");
        expect_plain(content_of(folder_ / "stderr.txt"));
    }
    write("codes.json", R"({"momentscope_session": 1, "scene": "planes", "\u001b]0;x\u0007\u009b31m": 1})");
    const Outcome session = run("--headless --size 640x400 --session codes.json --screenshot window.png");
    EXPECT_EQ(session.code, 0);
    EXPECT_NE(session.errors.find("]0;x  31m"), std::string::npos) << session.errors;
    expect_plain(session.errors);
}

TEST_F(CommandLineNames, JsonHasTheWholeNameOfAMesh) {
    const std::string name = CODES + "\xE9.obj";
    write(name, TRIANGLE);
    const Outcome needed =
        expect_words_succeed({"needed", "--scene", name, "--size", "16x9", "--format", "json"});
    EXPECT_EQ(json::parse(needed.output).at("scene"), CODES + "\uFFFD.obj");
    expect_plain(needed.output);
    expect_words_refused({"advise", "--scene", name, "--max-error", "0.5", "-o", "out/x.json"},
                         "is not UTF-8");
    write("x.events", "expect /scene none.obj\n");
    expect_words_refused({"--headless", "--size", "640x400", "--scene", name, "--events", "x.events"},
                         "\uFFFD.obj");
}

TEST_F(CommandLineNames, ChartsOfAnyNameCanBeReadAgain) {
    const std::string name = "a,b\n\"c|d`<e>&\x01\\n" + CODES + "\xE9.obj";
    write(name, TRIANGLE);
    expect_plain(expect_words_succeed({"chart", "--scene", name, "--size", "16x9", "--technique", "wboit",
                                       "--repeat", "1", "-o", "\xE9.csv"})
                     .output);
    fs::rename(folder_ / "\xE9.csv", folder_ / "x.csv");
    for (const char* other : {"y.csv", "x.svg", "x.html", "x.md"})
        expect_success(std::string("merge x.csv -o ") + other);
    EXPECT_EQ(content_of(folder_ / "y.csv"), content_of(folder_ / "x.csv"));
    expect_plain(content_of(folder_ / "x.html"));
    EXPECT_EQ(
        std::system(fmt::format("python3 -c 'import sys, xml.dom.minidom as x; x.parse(sys.argv[1])' '{}'",
                                (folder_ / "x.svg").string())
                        .c_str()),
        0)
        << content_of(folder_ / "x.svg");
    const std::string page = content_of(folder_ / "x.md");
    EXPECT_NE(page.find("\n## `` a,b \"c\\|d`<e>& \\n [31m   31m\uFFFD.obj ``\n"), std::string::npos) << page;
}

TEST_F(CommandLineNames, ALimitOfFilesIsAFailureLikeAnother) {
    const auto limit = [] {
        const rlimit bytes = {2000, 2000};
        ::setrlimit(RLIMIT_FSIZE, &bytes);
    };
    expect_words_refused(words_of("inspect --ray ray.json -o out/x.json"), "could not be written", limit);
    const Outcome outcome = run_words(words_of("inspect --ray ray.json"), limit);
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.errors.find("Standard output could not be written"), std::string::npos)
        << outcome.errors;
}

#ifndef __SANITIZE_ADDRESS__  // AddressSanitizer reports crashes itself

TEST_F(CommandLineNames, ADriverThatCrashesIsNamed) {
    const auto unknown = [] { ::setenv("GALLIUM_DRIVER", "nosuch", 1); };
    expect_words_refused(words_of("render --scene planes --size 16x9 -o out/x.png"), "GALLIUM_DRIVER",
                         unknown);
}

TEST_F(CommandLineNames, ALibraryThatCrashesAtStartIsNamed) {
    const int status =
        std::system(fmt::format("LD_PRELOAD='{}' '{}' list scenes >'{}' 2>&1", CRASHING_LIBRARY,
                                MOMENTSCOPE_BINARY, (folder_ / "started.txt").string())
                        .c_str());
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 1);
    const std::string said = content_of(folder_ / "started.txt");
    ASSERT_TRUE(said.starts_with("momentscope: A library crashed")) << said;
    expect_one_sentence(said.substr(0, said.size() - 1));
}

#endif

}  // namespace
