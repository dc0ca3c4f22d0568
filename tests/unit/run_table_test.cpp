// run_table_test.cpp -- files of runs and their shards: which are merged, and which are refused and why.
#include "core/table/run_table.hpp"
#include "core/support/output_file.hpp"
#include "tests/unit/expect_error.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

using namespace momentscope;

namespace {

namespace fs = std::filesystem;

class RunTables : public testing::Test {
protected:
    RunTables() : folder_(fs::temp_directory_path() / ("momentscope_tables_" + std::to_string(::getpid()))) {
        fs::create_directories(folder_);
    }
    ~RunTables() override {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }

    static RunTable table_of(const Shard& shard, std::size_t rows) {
        RunTable table = {begin_settings("chart", 1, rows, shard), "name,value", {}};
        table.settings.emplace_back("size", "64x36");
        table.settings.emplace_back(
            "configurations",
            "unsorted wboit power4-32 power6-32 power8-32 trig2-32 trig3-32 trig4-32 sorted peeling");
        for (std::size_t i = 0; i < rows; ++i)
            if (shard.holds(i)) table.rows.push_back("row," + std::to_string(i));
        return table;
    }

    fs::path write(const std::string& name, const RunTable& table) const {
        write_file(run_table_text(table), folder_ / name);
        return folder_ / name;
    }

    void expect_unmergeable(const RunTable& second, const std::string& part) const {
        const auto first = write("a.csv", table_of({1, 2}, 5));
        expect_error([&] { merge_shards({first, write("b.csv", second)}); }, part);
    }

    fs::path folder_;
};

TEST_F(RunTables, ShardsInAnyOrderMakeTheWhole) {
    for (const int count : {1, 2, 3, 7}) {
        std::vector<fs::path> paths;
        for (int i = count; i >= 1; --i) paths.push_back(write(std::to_string(i), table_of({i, count}, 5)));
        EXPECT_EQ(run_table_text(merge_shards(paths)), run_table_text(table_of({}, 5))) << count;
    }
}

TEST_F(RunTables, OtherRunsAreRefusedWithTheDifference) {
    const auto changed = [](const char* name, const std::string& value) {
        RunTable table = table_of({2, 2}, 5);
        for (auto& [one, old] : table.settings)
            if (one == name) old = value;
        return table;
    };
    expect_unmergeable(changed("size", "32x18"), "size is 32x18 instead of 64x36");
    expect_unmergeable(changed("schema", "2"), "schema is 2 instead of 1");
    expect_unmergeable(changed("version", "0.0.1"), "version is 0.0.1");
    expect_unmergeable(changed("momentscope", "stress"), "momentscope is stress");
    expect_unmergeable(changed("shard", "2/3"), "one of 3 shards instead of 2");
    expect_unmergeable(changed("shard", "5/4"), "is not a shard");
    expect_unmergeable(
        changed("configurations",
                "unsorted wboit power4-32 power6-32 power8-32 trig2-32 trig3-32 trig4-32 sorted at:nodes=8"),
        "only its configurations have at:nodes=8");
    RunTable columns = table_of({2, 2}, 5);
    columns.columns = "name";
    expect_unmergeable(columns, "its columns differ");
}

TEST_F(RunTables, LineBreaksAndBackslashesSurvive) {
    RunTable table = table_of({}, 2);
    table.settings.emplace_back("scenes", "a\nb\r\\n\\ # x: y");
    table.rows[0] = "\"a\n# b: \"\"c\",1";
    const RunTable read = read_run_table(write("a.csv", table));
    EXPECT_EQ(read.settings, table.settings);
    EXPECT_EQ(read.columns, table.columns);
    EXPECT_EQ(read.rows, table.rows);
}

TEST_F(RunTables, MissingDoubledAndUnfinishedShardsAreRefused) {
    expect_unmergeable(table_of({1, 2}, 5), "are both shard 1/2");
    RunTable short_one = table_of({2, 2}, 5);
    short_one.rows.pop_back();
    expect_unmergeable(short_one, "1 of the 2 rows");
    expect_error([&] { merge_shards({write("a.csv", table_of({1, 2}, 5))}); }, "Shard 2/2 is missing");
    expect_error([&] { merge_shards({write("a.csv", table_of({1, 9}, 5))}); }, "Shard 2/9 is missing");
}

TEST_F(RunTables, OtherFilesAreRefused) {
    expect_error([&] { read_run_table(folder_ / "none.csv"); }, "no CSV file");
    write_file("a,b\n1,2\n", folder_ / "plain.csv");
    expect_error([&] { read_run_table(folder_ / "plain.csv"); }, "does not say to which run");
    expect_error([&] { read_run_table(folder_); }, "no CSV file");
}

TEST_F(RunTables, FilesLargerThanAnyRunAreRefused) {
    RunTable many = table_of({}, 0);
    many.rows.resize(100'001);
    expect_error([&] { read_run_table(write("rows.csv", many)); }, "more than 100000 rows or 1000 settings");
    many.rows.clear();
    many.settings.resize(1001, {"x", "y"});
    expect_error([&] { read_run_table(write("settings.csv", many)); },
                 "more than 100000 rows or 1000 settings");
    many.settings = {{"x", std::string((4 << 20) + 1, 'y')}};
    expect_error([&] { read_run_table(write("setting.csv", many)); }, "a setting of more than 4 MiB");
}

TEST_F(RunTables, ShardsLargerThanAnyRunTogetherAreRefused) {
    RunTable half = table_of({1, 2}, 2);
    half.rows[0].assign(std::size_t{33} << 20, 'x');
    const auto path = write("half.csv", half);
    expect_error([&] { merge_shards({path, path}); }, "larger than 64 MiB together");
}

// Comparing each word with all others would take minutes here.
TEST_F(RunTables, LongListsAreCompared) {
    RunTable one = table_of({1, 2}, 2), other = table_of({2, 2}, 2);
    std::string words;
    for (int i = 0; i < 200'000; ++i) words += fmt::format("w{} ", i);
    one.settings.emplace_back("words", words);
    other.settings.emplace_back("words", words + "more");
    expect_error(
        [&] {
            merge_shards({write("a.csv", one), write("b.csv", other)});
        },
        "only its words have more");
}

TEST(Shards, AreParsed) {
    EXPECT_EQ(parse_shard("2/4").index, 2);
    EXPECT_EQ(parse_shard("2/4").count, 4);
    for (const char* wrong : {"5/4", "0/4", "1", "/", "1/", "a/b", "-1/4", "1/0", "1/4/2", "1/99999"})
        expect_error([&] { parse_shard(wrong); }, "is not a shard");
}

}  // namespace
