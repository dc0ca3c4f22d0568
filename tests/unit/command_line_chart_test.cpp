// command_line_chart_test.cpp -- charts, their shards, and advice from them.
#include "tests/unit/command_line_fixture.hpp"

#include <nlohmann/json.hpp>

using namespace momentscope;
using namespace momentscope::test;

namespace {

using nlohmann::json;

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

}  // namespace
