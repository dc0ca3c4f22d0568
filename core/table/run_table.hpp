// run_table.hpp -- tables of long runs as CSV files that say of which run they are, and shards of them.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace momentscope {

/// A part of a run: every count-th row from the index-th on, so that all parts take about as long.
struct Shard {
    int index = 1;  // from 1 to count
    int count = 1;

    bool holds(std::size_t row) const {
        return row % static_cast<std::size_t>(count) == static_cast<std::size_t>(index) - 1;
    }
};

/// "2/4". Throws Error unless it is one of at most 10,000.
Shard parse_shard(std::string_view text);
std::string shard_text(const Shard& shard);

/// What a run was: names and values in the order in which they are written.
using RunSettings = std::vector<std::pair<std::string, std::string>>;

/// The value of a name; empty when there is none.
std::string setting(const RunSettings& settings, std::string_view name);

/// What differs first, as "its size is 640x360 instead of 320x180"; nullopt when nothing does. Names in `but`
/// are not compared.
std::optional<std::string> difference_of(const RunSettings& settings, const RunSettings& wanted,
                                         std::string_view but = {});

/// A CSV file: `# name: value` for every setting, with line breaks and backslashes of values escaped by a
/// backslash; the names of columns; one record per row.
struct RunTable {
    RunSettings settings;
    std::string columns;
    std::vector<std::string> rows;
};

std::string run_table_text(const RunTable& table);

/// Throws Error when the file cannot be read, is not such a table or is larger than any run.
RunTable read_run_table(const std::filesystem::path& path);

/// Settings that every run has; the rest is the command's.
namespace run_setting {
constexpr const char* COMMAND = "momentscope";  // which one made it
constexpr const char* SCHEMA = "schema";        // of the columns
constexpr const char* VERSION = "version";      // of the program
constexpr const char* ROWS = "rows";            // of the whole run
constexpr const char* SHARD = "shard";
}  // namespace run_setting

/// The first settings of a run of that command, of so many rows in all its shards.
RunSettings begin_settings(std::string_view command, int schema, std::size_t rows, const Shard& shard);

/// The whole table of all shards of one run, in whatever order they come. Throws Error when they are of
/// different runs, when one is missing, comes twice or is not finished, with the names of the files, and when
/// they are too large together.
RunTable merge_shards(const std::vector<std::filesystem::path>& paths);

}  // namespace momentscope
