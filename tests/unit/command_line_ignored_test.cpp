// command_line_ignored_test.cpp -- options without an effect are refused, and options that used to be ignored
// have an effect now.
#include "tests/unit/command_line_fixture.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

using namespace momentscope;
using namespace momentscope::test;

namespace {

using nlohmann::json;

TEST_F(CommandLine, RefusesWhatWouldChangeNothing) {
    write("line.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::pair<const char*, const char*> ignored[] = {
        {"--beta 0.5 render --scene planes -o out/x.png", "--beta stands before 'render'"},
        {"--size 64x48 list scenes", "--size stands before 'list'"},
        {"inspect --ray ray.json --size 8x8 -o out/x", "--size changes nothing together with --ray"},
        {"inspect --ray ray.json --gl egl -o out/x", "--gl changes nothing together with --ray"},
        {"compare one.png two.png --gl egl", "--gl"},
        {"stress --gl egl -o out/x.csv", "--gl changes nothing without a .png"},
        {"merge --gl egl one.csv -o out/x.csv", "--gl changes nothing without a .png"},
        {"inspect --ray ray.json --samples 5 --depths 0 -o out/x",
         "--samples changes nothing together with --depths"},
        {"inspect --ray ray.json --steps --samples 5 -o out/x", "--samples"},
        {"inspect --ray ray.json --opacity 0.5 -o out/x", "--opacity changes nothing"},
        {"inspect --ray ray.json --shadows -o out/x", "--shadows changes nothing"},
        {"inspect --ray ray.json --tone-map filmic -o out/x", "--tone-map changes nothing"},
        {"inspect --ray ray.json --order-seed 2 -o out/x",
         "--order-seed changes nothing without --order shuffled"},
        {"inspect --ray ray.json --technique power4-32 --theta 1 -o out/x",
         "--theta changes nothing with power4-32"},
        {"render --scene planes --nodes 8 -o out/x.png", "--nodes changes nothing with power6-32"},
        {"render --scene planes --opacity 0.5 -o out/x.png", "--opacity changes nothing"},
        {"render --scene planes --shadow-size 512 -o out/x.png",
         "--shadow-size changes nothing without --shadows"},
        {"render --scene planes --tone-map filmic -o out/x.exr", "--tone-map changes nothing"},
        {"compare one.png two.png --scene planes", "--scene changes nothing when both pictures are files"},
        {"compare one.png two.png --size 8x8", "--size"},
        {"compare one.png two.png --beta 0.5", "--beta"},
        {"needed --scene planes --beta 0.5", "--beta"},
        {"needed --scene planes --uncertainty sharp4 --basis power", "--basis changes nothing"},
        {"needed --scene planes --interval pixel", "set the ends to known"},
        {"stress --technique power4-32 --interval pixel", "power4-32: The pixel's own interval"},
        {"tune --random 5 --technique adaptive --ends known --interval pixel", "leave the interval at scene"},
        {"needed --scene planes --uncertainty sharp4 --tolerance 0.1", "--tolerance"},
        {"stress --technique power4-32 --theta 1", "--theta"},
        {"stress --technique power4-32 --tone-map filmic", "--tone-map"},
        {"tune --random 5 --size 8x8", "--size changes nothing without a scene"},
        {"tune --ray ray.json --seed 2", "--seed changes nothing without --random"},
        {"tune --ray ray.json --nodes 4", "--nodes"},
        {"chart --scene planes --technique wboit --beta 0.5", "--beta"},
        {"chart --scene planes --metric flip -o out/x.csv", "--metric changes nothing in a .csv"},
        {"chart --scene planes --shadows --metric flip", "--metric changes nothing together with --shadows"},
        {"advise --scene planes --max-error 0.1 --technique wboit --nodes 4", "--nodes"},
        {"merge one.csv --metric flip -o out/x.csv", "--metric"},
        {"explore --headless --screenshot out/x.png --ray ray.json --compare at", "--compare"},
        {"inspect --ray ray.json --technique fourier --lanczos '' -o out/x", "--lanczos"},
        {"inspect --ray ray.json --renormalize= -o out/x", "--renormalize"},
    };
    for (const auto& [line, part] : ignored) expect_refused(line, part);
}

TEST_F(CommandLine, AcceptsWhatChangesSomething) {
    write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    for (const char* line :
         {"inspect --ray ray.json --technique power4-32,trig2-32 --theta 1 --samples 3",
          "inspect --ray ray.json --technique fourier --lanczos --samples 3",
          "inspect --ray ray.json --order shuffled --order-seed 2 --samples 3",
          "inspect --scene planes --size 16x9 --light --shadow-size 64 --samples 3",
          "render --scene triangle.obj --size 16x9 --opacity 0.2 --tone-map filmic -o out/x.png",
          "render --scene planes --size 16x9 --shadows --shadow-size 64 -o out/x.png",
          "tune --random 5 --seed 2 --technique power4-32 --solver textbook"})
        expect_success(line);
}

// Red sheets in front of a blue one: alpha blending is right if they are submitted back to front.
TEST_F(CommandLine, OrderActsOnARay) {
    write("ftb.json", R"({"fragments": [{"depth": -0.5, "opacity": 0.6, "color": [1, 0, 0]},
                                        {"depth": 0.5, "opacity": 0.6, "color": [0, 0, 1]}]})");
    const std::string line = "inspect --ray ftb.json --technique unsorted --depths 0 --format table";
    EXPECT_NE(expect_success(line).output.find("the order of submission"), std::string::npos);
    EXPECT_NE(expect_success(line + " --order reversed").output.find("Right to 0.0000"), std::string::npos);
}

// A surface at the near end of the depth range is visible to every depth behind it.
TEST_F(CommandLine, ASurfaceAtTheNearEndStays) {
    for (const auto& [opacity, absorbance] : {std::pair(0.5, 0.6931), std::pair(0.999, 6.908)}) {
        write("edge.json", fmt::format(R"({{"fragments": [{{"depth": -1, "opacity": {}}}]}})", opacity));
        const json root = json::parse(
            expect_success(
                "inspect --ray edge.json --technique trig2-32,trig3-32,trig4-32 --depths=-0.5,0,0.9")
                .output);
        for (const json& curve : root["curves"])
            for (const json& value : curve["reconstructed"])
                EXPECT_NEAR(value.get<double>(), absorbance, 1e-3) << curve["technique"];
    }
}

// Two panes at the same place and one in front: the picture, curve and breakdown of peeling agree that one is
// lost.
TEST_F(CommandLine, PeelingTellsWhatItLoses) {
    const std::string pane = "v -1 -0.8 {0}\nv 1 -0.8 {0}\nv 1 0.8 {0}\nv -1 0.8 {0}\n";
    write("same.obj", fmt::format(fmt::runtime(pane), 0) + "f 1 2 3 4\n" +
                          fmt::format(fmt::runtime(pane), 0) + "f 5 6 7 8\n" +
                          fmt::format(fmt::runtime(pane), 0.5) + "f 9 10 11 12\n");
    const std::string line = "inspect --scene same.obj --size 160x90 --pixel 80,45 --samples 2 --format ";
    const json root = json::parse(expect_success(line + "json --technique sorted,peeling").output);
    const double one = -std::log(0.6);
    EXPECT_NEAR(root["curves"][0]["reconstructed"][1].get<double>(), 3 * one, 1e-5);
    EXPECT_NEAR(root["curves"][1]["reconstructed"][1].get<double>(), 2 * one, 1e-5);
    EXPECT_NE(expect_success(line + "table --technique peeling").output.find("1 of 3 fragments is lost"),
              std::string::npos);
}

}  // namespace
