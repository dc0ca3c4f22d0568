// command_line_window_test.cpp -- the window without a display: events, sessions, screenshots, options.
#include "tests/unit/command_line_fixture.hpp"

using namespace momentscope;
using namespace momentscope::test;

namespace {

TEST_F(CommandLine, ExploreNeedsADisplayOrAFile) {
    expect_refused("explore", "--headless");
    expect_refused("", "--headless");
    expect_refused("explore --headless", "--screenshot");
    expect_refused("explore --screenshot out/x.png", "--headless");
    expect_refused("explore --headless --screenshot out/x.jpg", ".png");
}

TEST_F(CommandLine, EventsAreReplayedAndWrongOnesNamed) {
    write("good.events", "key L\nexpect /lens true\nscreenshot out/window.png\nwait 60\n");
    const std::string small = "--scene planes --size 640x400 --headless --events ";
    const Outcome good = run(small + "good.events --log out/log.txt");
    EXPECT_EQ(good.code, 0) << good.errors;
    EXPECT_GT(fs::file_size(folder_ / "out/window.png"), 1000u);
    EXPECT_NE(content_of(folder_ / "out/log.txt").find("waited 60 s: 0 frames"), std::string::npos);
    fs::remove_all(folder_ / "out");
    fs::create_directories(folder_ / "out");
    for (const auto& [event, said] :
         {std::pair("jump 3", "no event 'jump'"), std::pair("click @nothing", "no control '@nothing'"),
          std::pair("move 1", "needs a number"), std::pair("key Hyper+X", "no key 'Hyper+X'"),
          std::pair("drag 1 2 3 4", "second place"), std::pair("expect /lens true", "/lens is false"),
          std::pair("expect /nowhere 1", "no '/nowhere'"), std::pair("wheel 1e9", "needs a number"),
          std::pair("press nose", "no mouse button"), std::pair("resize 0 0", "needs a number")}) {
        write("bad.events", std::string("# a comment\n") + event + "\n");
        expect_refused(small + "bad.events", said);
    }
    expect_refused(small + "missing.events", "no event file");
}

TEST_F(CommandLine, RefusesWrongWindowOptions) {
    write("old.json", R"({"momentscope_session": 0})");
    expect_refused("--headless --screenshot out/a.png --session old.json", "version 0");
    expect_refused("--headless --screenshot out/a.png --session none.json", "no session file");
    expect_refused("--headless --screenshot out/a.png --ui-scale 9", "0.5 to 4");
    expect_refused("--headless --screenshot out/a.png --theme pink", "dark or light");
    expect_refused("--headless --screenshot out/a.png --compare nonsense", "no technique 'nonsense'");
    expect_refused("render --technique mt --resolution half --read-format nlqm32 -o out/a.png",
                   "cannot be filtered");
    expect_refused("inspect --ray tests/none.json --technique mt --resolution half --read-format nlqm64",
                   "cannot be filtered");
    expect_refused("render --technique stochastic --pixel-samples 65 -o out/a.png", "pixel-samples");
    expect_refused("render --order sideways -o out/a.png", "sideways");
    expect_refused("figure fig99 -o out/figures", "no figure 'fig99'");
    expect_refused("--headless --screenshot out/a.png --log none/log.txt", "no folder");
}

}  // namespace
