// command_line_test.cpp -- tests the program itself: each wrong input fails with one line, and each right one
// prints or writes.
#include "core/techniques/technique.hpp"
#include "tests/unit/command_line_fixture.hpp"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

using namespace momentscope;
using namespace momentscope::test;

namespace {

using nlohmann::json;

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

TEST_F(CommandLine, WarnsOfWhatAMeshMeansOtherwise) {
    std::ofstream(folder_ / "line.obj") << "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n";
    for (const char* command : {"inspect --scene line.obj --size 16x9 --technique unsorted --format json",
                                "explore --headless --scene line.obj --size 160x90 --screenshot out/x.png"}) {
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.code, 0) << command;
        EXPECT_TRUE(outcome.errors.starts_with("momentscope: The mesh file 'line.obj' shows almost nothing"))
            << outcome.errors;
    }
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

TEST_F(CommandLine, RefusesWrongChartsAndShards) {
    const std::string chart = "chart --size 16x9 -o out/x.csv ";
    expect_refused(chart + "--scene nowhere", "no scene 'nowhere'");
    expect_refused(chart + "--scene planes,", "no scene ''");
    expect_refused(chart + "--scene planes --technique nothing", "no technique 'nothing'");
    expect_refused(chart + "--scene planes --technique ''", "has no value");
    expect_refused(chart + "--scene planes --technique at:layers=2", "no parameter 'layers'");
    expect_refused(chart + "--repeat 0", "number of rounds");
    expect_refused(chart + "--shard 5/4", "'5/4' is not a shard");
    expect_refused("chart --size 16x9 -o out/x.md --metric psnr", "no metric 'psnr'");
    expect_refused("chart --scene planes -o out/x.jpg", "does not end in .csv");
    expect_refused("chart --scene planes --shard 1/2 -o out/x.html", "ends in .csv");
    expect_refused("stress --shard 0/2 -o out/x.csv", "is not a shard");
    expect_refused("stress --shard 1/2 -o out/x.html", "ends in .csv");
    expect_refused("merge none.csv -o out/all.csv", "no CSV file");
    expect_refused("merge ray.json -o out/all.csv", "to which run");
    expect_refused("merge -o out/all.csv", "--help");
}

TEST_F(CommandLine, RefusesWrongBoundsOfAdvice) {
    const std::string advise = "advise --scene planes --size 16x9 -o out/x.json ";
    expect_refused("advise --scene planes", "--max-error is required");
    for (const char* error : {"0", "-1", "nan", "inf"})
        expect_refused(advise + "--max-error " + error, "give a number above 0");
    expect_refused(advise + "--max-error much", "not a greatest error");
    expect_refused(advise + "--max-error 0.1 --max-bits 0", "number of bits per pixel");
    expect_refused(advise + "--max-error 0.1 --max-ms 0", "above 0 milliseconds");
    expect_refused(advise + "--max-error 0.1 --max-ms soon", "not a time in milliseconds");
    expect_refused(advise + "--max-error 2 --metric flip", "never above 1");
    expect_refused(advise + "--max-error 0.1 --metric psnr", "no metric 'psnr'");
    expect_refused(advise + "--max-error 0.1 --technique nothing", "no technique 'nothing'");
    expect_refused("advise --scene nowhere --max-error 0.1", "no scene 'nowhere'");
    expect_refused("advise --scene planes --max-error 0.1 -o out/x.png", "is not");
    expect_refused(advise + "--max-error 1e-9 --technique wboit", "Nothing meets these bounds");
    expect_refused(advise + "--max-error 0.1 --technique unsorted --order-independent",
                   "None of these configurations");
    expect_refused(advise + "--max-error 0.1 --chart none.csv", "excludes");
}

TEST_F(CommandLine, AdviceTakesTheRowsOfAChart) {
    expect_success(
        "chart --scene planes --size 32x18 --repeat 1 --technique wboit,power4-32,power8-32 -o x.csv");
    const std::string advise = "advise --chart x.csv ";
    expect_refused(advise + "--scene spheres --max-error 0.1",
                   "no rows of the scene 'spheres', only of planes");
    expect_refused(advise + "--scene planes --max-error 0.1 --technique at", "no rows of these techniques");
    expect_refused(advise + "--scene planes --max-error 0.1 --beta 0", "leave --chart out");
    expect_refused("advise --chart ray.json --scene planes --max-error 0.1", "to which run");
    const Outcome outcome = expect_success(advise + "--scene planes --max-error 0.9 -o out/recipe.json");
    EXPECT_NE(outcome.output.find("Cheapest     "), std::string::npos) << outcome.output;
    const json recipe = json::parse(content_of(folder_ / "out/recipe.json"));
    EXPECT_EQ(recipe.at("scene"), "planes");
    expect_success("explore --headless --session out/recipe.json --screenshot window.png");
    const std::string printed = expect_success(advise + "--scene planes --max-error 0.9").output;
    EXPECT_EQ(json::parse(printed.substr(printed.find("\n{"))), recipe);
}

TEST_F(CommandLine, AnUnfinishedChartOfOtherSettingsIsKept) {
    write("x.csv.partial", "# momentscope: chart\n# schema: 1\n# rows: 2\n# shard: 1/1\n# size: 16x9\n");
    expect_refused("chart --scene planes --size 32x18 -o x.csv", "unfinished chart of another run");
    EXPECT_TRUE(fs::exists(folder_ / "x.csv.partial"));
    EXPECT_FALSE(fs::exists(folder_ / "x.csv"));
}

TEST_F(CommandLine, RefusesPicturesThatAreNone) {
    expect_refused("compare none.png none.png", "no picture 'none.png'");
    expect_refused("compare ray.json ray.json", "cannot be read (");
    write_picture(Image(4, 3), "a.exr");
    for (const char* region :
         {"1,2,3", "1,2,3,4,5", "1,2,3,x", "-1,0,2,2", "0,0,100000,1", "0,0,1.5,1", ",,,"})
        expect_refused(std::string("compare a.exr a.exr --region=") + region, "is not a region");
    expect_refused("compare a.exr a.exr --region 0,0,5,3", "does not lie within");
    expect_success("compare a.exr a.exr --region 1,0,3,3");
}

TEST_F(CommandLine, CompareTellsOfAlphaAndRefusesWhatIsNoNumber) {
    Image picture(4, 3);
    for (glm::vec4& pixel : picture.pixels) pixel = {0.25f, 0.5f, 0.75f, 1};
    write_picture(picture, "a.exr");
    EXPECT_EQ(expect_success("compare a.exr a.exr").output.find("alpha"), std::string::npos);
    picture.at(2, 1).a = 0.25f;
    write_picture(picture, "alpha.exr");
    EXPECT_NE(expect_success("compare a.exr alpha.exr").output.find("differ by at most 0.75"),
              std::string::npos);
    picture.at(1, 2).g = std::nanf("");
    picture.at(3, 2).b = INFINITY;
    write_picture(picture, "nan.exr");
    expect_refused("compare a.exr nan.exr",
                   "2 of the 12 pixels of 'nan.exr' are infinite or NaN, the first at 1,2");
    expect_refused("compare nan.exr nan.exr --metric rmse", "nan.exr");
}

TEST_F(CommandLine, ALineBreakInAnArgumentStaysOnOneLine) {
    expect_refused("inspect --ray ray.json --technique 'a\nb' -o out/x", "a");
    expect_refused("inspect --ray 'a\nb' -o out/x", "a");
    expect_refused("'--a\nb'", "a");
}

TEST_F(CommandLine, ListsTheRegistries) {
    const json rows = json::parse(expect_success("list techniques --format json").output);
    std::set<std::string> ids;
    for (const json& row : rows) ids.insert(row.at("id").get<std::string>());
    EXPECT_EQ(rows.size(), techniques().size());
    for (const Technique& technique : techniques()) EXPECT_EQ(ids.count(technique.id), 1u) << technique.id;
    EXPECT_EQ(json::parse(expect_success("list parameters --format json").output).size(), PARAMETER_COUNT);
    EXPECT_GE(json::parse(expect_success("list scenes --format json").output).size(), 3u);
    EXPECT_TRUE(expect_success("list techniques").output.starts_with("power4-32   160 "));
    for (const char* list : {"scenes", "parameters", "conditions", "figures", "commands"}) {
        const std::string text = expect_success(std::string("list ") + list + " --format markdown").output;
        EXPECT_TRUE(text.starts_with("| ")) << text;
        EXPECT_NE(text.find("\n| --- |"), std::string::npos) << text;
    }
}

TEST_F(CommandLine, InspectPrintsTheTruthAsJsonCsvAndTable) {
    const std::string inspect =
        "inspect --ray ray.json --technique power8-32,trig2-32 --depths=-0.5,0,1 --format ";
    const json root = json::parse(expect_success(inspect + "json").output);
    ASSERT_EQ(root["curves"].size(), 2u);
    const auto truth = root["curves"][1]["true"].get<std::vector<double>>();
    ASSERT_EQ(truth.size(), 3u);
    EXPECT_EQ(truth[0], 0.0);
    EXPECT_NEAR(truth[1], std::log(2.0), 2e-7);  // 3 ulps of a float
    EXPECT_NEAR(truth[2], std::log(8.0), 6e-7);
    for (const char* key : {"depth", "true", "reconstructed", "lower", "upper"})
        for (const json& value : root["curves"][0][key]) EXPECT_TRUE(value.is_number()) << key;

    const std::string csv = expect_success(inspect + "csv").output;
    EXPECT_NE(csv.find("\npower8-32,-0.5,0,"), std::string::npos) << csv;
    EXPECT_NE(csv.find("\ntrig2-32,0,0.69314"), std::string::npos) << csv;
    const std::string table = expect_success(inspect + "table").output;
    EXPECT_TRUE(table.starts_with("2 fragments, total absorbance 2.07944\n")) << table;
    EXPECT_NE(table.find("    0.000000    0.693147"), std::string::npos) << table;
    EXPECT_NE(table.find("\npower8-32: "), std::string::npos) << "the verdict; " << table;
    const std::string twice =
        expect_success("inspect --ray ray.json --technique at,at:nodes=8 --depths=0 --format csv").output;
    EXPECT_NE(twice.find("\nat:nodes=8,0,"), std::string::npos) << twice;
    for (const std::string& text : {csv, table})
        for (const char* word : {"nan", "null", "inf"}) EXPECT_EQ(text.find(word), std::string::npos) << text;
}

TEST_F(CommandLine, InspectTakesTheSamplesAndWritesTheFile) {
    const Outcome outcome = expect_success("inspect --ray ray.json --samples 7 -o out/curves.json");
    EXPECT_EQ(outcome.output, "");
    const json root = json::parse(content_of(folder_ / "out" / "curves.json"));
    EXPECT_EQ(root["curves"][0]["technique"], "power6-32");
    EXPECT_EQ(root["curves"][0]["depth"].size(), 7u);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "out"), {}), 1);  // no partial file is left
    EXPECT_EQ(json::parse(expect_success("inspect --ray ray.json --samples 7").output), root);
    write("wrong.json", "[");
    EXPECT_EQ(run("inspect --ray wrong.json -o out/curves.json").code, 1);
    EXPECT_EQ(json::parse(content_of(folder_ / "out" / "curves.json")),
              root);  // a failure keeps the old file
}

// The program is started like by a user, not forked.
TEST_F(CommandLine, TheProgramIsWhatIsTestedHere) {
    const std::string program = std::string("cd '") + folder_.string() + "' && '" + MOMENTSCOPE_BINARY + "' ";
    EXPECT_EQ(std::system((program + "list techniques >started.txt").c_str()), 0);
    EXPECT_EQ(content_of(folder_ / "started.txt"), expect_success("list techniques").output);
    const int refused = std::system((program + "list nonsense >started.txt 2>&1").c_str());
    EXPECT_EQ(WEXITSTATUS(refused), 1);
    EXPECT_EQ(content_of(folder_ / "started.txt"), run("list nonsense").errors);
}

TEST_F(CommandLine, HelpSucceedsAndNamesEveryParameter) {
    const std::string help = expect_success("inspect --help").output;
    for (const Parameter& row : parameters())
        EXPECT_NE(help.find(std::string("--") + row.key + " "), std::string::npos) << row.key;
}

// docs/cli.md must equal the program's own description.
TEST_F(CommandLine, HasItsPage) {
    std::ifstream file("docs/cli.md");
    std::stringstream text;
    text << file.rdbuf();
    EXPECT_EQ(expect_success("list options --format markdown").output, text.str())
        << "momentscope list options --format markdown > docs/cli.md";
}

}  // namespace
