// command_line_test.cpp -- tests the program itself: what it lists, inspects, warns of and says about itself.
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
