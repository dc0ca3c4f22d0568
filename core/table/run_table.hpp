// run_table.hpp -- tables of long runs as CSV files that name the run they belong to, and shards of them.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace momentscope {

/// A part of a run: every count-th row, starting with row index - 1. So all parts take about the same time.
struct Shard {
    int index = 1;  // in [1, count]
    int count = 1;

    bool holds(std::size_t row) const {
        return row % static_cast<std::size_t>(count) == static_cast<std::size_t>(index) - 1;
    }
};

/// The shard of a text such as "2/4", and the text of a shard. Throws Error unless the text names one of at
/// most 10,000 shards.
Shard parse_shard(std::string_view text);
std::string shard_text(const Shard& shard);

/// The settings of a run: names and values, in the order in which they are written.
using RunSettings = std::vector<std::pair<std::string, std::string>>;

/// The value of a name; empty if there is none.
std::string setting(const RunSettings& settings, std::string_view name);

/// The first difference, as "its size is 640x360 instead of 320x180"; nullopt if there is none. Names in
/// `but` are not compared.
std::optional<std::string> difference_of(const RunSettings& settings, const RunSettings& wanted,
                                         std::string_view but = {});

/// A CSV file. It has a line `# name: value` for each setting, with line breaks and backslashes of values
/// escaped by a backslash; then the names of the columns; then one record per row.
struct RunTable {
    RunSettings settings;
    std::string columns;
    std::vector<std::string> rows;
};

std::string run_table_text(const RunTable& table);

/// Reads a table. Throws Error if the file cannot be read, is not such a table or is larger than any run.
RunTable read_run_table(const std::filesystem::path& path);

/// Names of settings that every run has. Commands add others.
namespace run_setting {
constexpr const char* COMMAND = "momentscope";  // the command that made the table
constexpr const char* SCHEMA = "schema";        // of the columns
constexpr const char* VERSION = "version";      // of the program
constexpr const char* ROWS = "rows";            // of the whole run
constexpr const char* SHARD = "shard";
}  // namespace run_setting

/// The first settings of a run of this command, with `rows` rows in all of its shards.
RunSettings begin_settings(std::string_view command, int schema, std::size_t rows, const Shard& shard);

/// The complete table of a run from all of its shards, in any order. Throws Error, with the names of the
/// files, if they belong to different runs, if a shard is missing, comes twice or is not finished, and if
/// they are too large together.
RunTable merge_shards(const std::vector<std::filesystem::path>& paths);

}  // namespace momentscope
