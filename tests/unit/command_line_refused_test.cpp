// command_line_refused_test.cpp -- wrong input, and outputs that cannot be written, fail with one line.
#include "tests/unit/command_line_fixture.hpp"

using namespace momentscope;
using namespace momentscope::test;

namespace {

TEST_F(CommandLine, RefusesUnknownScenesTechniquesOptionsAndFormats) {
    expect_refused("render --scene nowhere -o out/x.png", "no scene 'nowhere'");
    expect_refused("render --scene planes --technique power5-32 -o out/x.png", "no technique 'power5-32'");
    expect_all_refused("inspect --ray ray.json ", {"--gamma 2", "stray"}, "--help");
    expect_all_refused("inspect --ray ray.json --technique ", {"power4-32,"}, "no technique");
    expect_all_refused("inspect --ray ray.json --technique ", {"''"}, "has no value");
    expect_refused("inspect --ray ray.json --format xml -o out/x", "json, csv or table");
    expect_refused("list nonsense", "no list 'nonsense'");
    expect_refused("list techniques --format csv", "table, json or markdown");
    expect_refused("inspect --ray ray.json --technique fourier --lanczos 0.5 -o out/x", "--lanczos");
    expect_refused("render --scene planes", "--help");
}

TEST_F(CommandLine, RefusesUnknownKindsOfGl) {
    expect_refused("render --gl vulkan --scene planes -o out/x.png",
                   "use osmesa, egl, egl-es, window or auto");
    expect_refused("explore --gl egl", "add --headless");
    ::setenv("MOMENTSCOPE_GL", "metal", 1);
    expect_refused("render --scene planes --size 8x8 -o out/x.png", "'metal'");
    ::unsetenv("MOMENTSCOPE_GL");
}

TEST_F(CommandLine, RefusesWrongParameters) {
    expect_all_refused("inspect --ray ray.json --beta ", {"1.5", "nan", "x", "auto"}, "--beta");
    expect_refused("inspect --ray ray.json --beta=-0.1 -o out/x", "--beta");
    expect_refused("inspect --ray ray.json --alpha 0.2 -o out/x", "--alpha");
    expect_refused("inspect --ray ray.json --theta inf -o out/x", "--theta");
    expect_refused("render --scene planes --opacity 1 -o out/x.png", "--opacity");
}

TEST_F(CommandLine, RefusesWrongPixelsSizesAndCounts) {
    const std::string picture = "inspect --scene planes --size 96x54 --pixel ";
    expect_all_refused(picture, {"96,0", "0,54", "x", "1,2,3"}, "0,0 to 95,53");
    expect_refused("inspect --scene planes --size 96x54 --pixel=-1,0 -o out/x", "0,0 to 95,53");
    for (const char* size : {"0x0", "1000000x1000000", "junk", "-1x5"})
        expect_refused(std::string("render --scene planes --size=") + size + " -o out/x.png", "The size");
    expect_all_refused("inspect --ray ray.json --samples ", {"1", "x", "1000001"}, "number of samples");
    expect_all_refused("inspect --ray ray.json --depths ", {"2", "nan", "0,,1"}, "depth");
}

TEST_F(CommandLine, RefusesWrongRays) {
    expect_refused("inspect --ray out -o out/x", "no view ray file 'out'");
    const std::pair<std::string, std::string> wrong[] = {
        {"", "not valid JSON"},
        {"{\"fragments\": [", "not valid JSON"},
        {std::string(100'000, '['), "nested too deeply"},
        {R"({"fragments": [{"depth": NaN, "opacity": 0.5}]})", "not valid JSON"},
        {R"({"fragments": [{"depth": 0, "opacity": 2}]})", "opacity 2"},
        {R"({"fragments": [{"depth": 3, "opacity": 1}]})", "depth 3"},
    };
    for (const auto& [content, part] : wrong) {
        write("wrong.json", content);
        expect_refused("inspect --ray wrong.json -o out/x", part);
    }
}

TEST_F(CommandLine, RefusesWrongMeshes) {
    fs::create_directories(folder_ / "folder.obj");
    expect_refused("render --scene folder.obj -o out/x.png", "is a folder");
    write("broken.obj", "v 0 0 zero\nf 1 2 3\n");
    expect_refused("render --scene broken.obj -o out/x.png", "broken.obj");
    write("noise.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nend_header\n\1\2\3");
    expect_refused("render --scene noise.ply -o out/x.png", "noise.ply");
    write("empty.glb", "");
    expect_refused("inspect --scene empty.glb -o out/x", "empty.glb");
}

TEST_F(CommandLine, RefusesOutputsThatCannotBeWritten) {
    fs::create_directories(folder_ / "folder.png");
    expect_refused("render --scene planes -o missing/x.png", "no folder 'missing'");
    expect_refused("render --scene planes -o folder.png", "'folder.png' is a folder");
    for (const char* name : {"out/x.jpg", "out/png"})
        expect_refused(std::string("render --scene planes -o ") + name, ".png or .exr");
    expect_refused("inspect --ray ray.json -o missing/x", "no folder");
    expect_refused("inspect --ray ray.json -o out", "is a folder");
}

TEST_F(CommandLine, ALineBreakInAnArgumentStaysOnOneLine) {
    expect_refused("inspect --ray ray.json --technique 'a\nb' -o out/x", "a");
    expect_refused("inspect --ray 'a\nb' -o out/x", "a");
    expect_refused("'--a\nb'", "a");
}

}  // namespace
