#include "core/table/run_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>

#include "core/support/error.hpp"
#include "core/support/input_file.hpp"
#include "core/support/markup.hpp"
#include "core/support/parse_number.hpp"
#include "core/support/version.hpp"

namespace momentscope {

namespace {

constexpr int MAX_SHARDS = 10'000;
// A chart has a few hundred rows of 300 bytes, a stress run a thousand rows of 15 KB. Larger tables would
// take more memory than they are worth.
constexpr std::uintmax_t MAX_BYTES = std::uintmax_t{64} << 20;
constexpr std::size_t MAX_ROWS = 100'000;
constexpr std::size_t MAX_SETTINGS = 1000;
// The longest value is a command with all its words, a few thousand letters.
constexpr std::size_t MAX_SETTING_BYTES = std::size_t{4} << 20;
constexpr std::size_t SHORT_VALUE = 60;  // letters that fit in a sentence

// A value takes one line, even if it is the name of a file with several lines.
std::string escaped(std::string_view value) {
    std::string result;
    for (const char letter : value)
        if (letter == '\\' || letter == '\n' || letter == '\r')
            result += letter == '\n' ? "\\n" : letter == '\r' ? "\\r" : "\\\\";
        else
            result += letter;
    return result;
}

std::string unescaped(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char next = text[i] == '\\' && i + 1 < text.size() ? text[++i] : '\0';
        if (next == '\0')
            result += text[i];
        else
            result += next == 'n' ? '\n' : next == 'r' ? '\r' : next;
    }
    return result;
}

std::vector<std::string_view> words_of(std::string_view text) {
    std::vector<std::string_view> words;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        words.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return words;
}

std::optional<std::string_view> word_only_in(std::string_view text, std::string_view other) {
    const auto words = words_of(other);
    const std::unordered_set<std::string_view> others(words.begin(), words.end());
    for (const std::string_view word : words_of(text))
        if (!others.contains(word)) return word;
    return std::nullopt;
}

// The sentence about a difference. For long lists it names only elements that one list has and the other does
// not.
std::string difference_text(const std::string& name, const std::string& value, const std::string& wanted) {
    if (std::max(value.size(), wanted.size()) <= SHORT_VALUE)
        return fmt::format("its {} is {} instead of {}", name, value.empty() ? "missing" : value,
                           wanted.empty() ? "missing" : wanted);
    if (const auto word = word_only_in(value, wanted)) return fmt::format("only its {} have {}", name, *word);
    if (const auto word = word_only_in(wanted, value)) return fmt::format("its {} lack {}", name, *word);
    return fmt::format("its {} are in another order", name);
}

std::size_t bytes_of(const RunTable& table) {
    std::size_t bytes = table.columns.size();
    for (const auto& [name, value] : table.settings) bytes += name.size() + value.size();
    for (const std::string& row : table.rows) bytes += row.size() + 1;
    return bytes;
}

}  // namespace

Shard parse_shard(std::string_view text) {
    const std::size_t slash = text.find('/');
    const auto index = parse_number<int>(text.substr(0, slash));
    const auto count =
        slash == std::string_view::npos ? std::nullopt : parse_number<int>(text.substr(slash + 1));
    if (!index || !count || *count < 1 || *count > MAX_SHARDS || *index < 1 || *index > *count)
        throw Error(fmt::format(
            "'{}' is not a shard; give its number and how many there are, as --shard 2/4.", text));
    return {*index, *count};
}

std::string shard_text(const Shard& shard) {
    return fmt::format("{}/{}", shard.index, shard.count);
}

std::string setting(const RunSettings& settings, std::string_view name) {
    for (const auto& [one, value] : settings)
        if (one == name) return value;
    return "";
}

std::optional<std::string> difference_of(const RunSettings& settings, const RunSettings& wanted,
                                         std::string_view but) {
    for (const auto* names : {&wanted, &settings})
        for (const auto& [name, ignored] : *names) {
            const std::string value = setting(settings, name), other = setting(wanted, name);
            if (name != but && value != other) return difference_text(name, value, other);
        }
    return std::nullopt;
}

std::string run_table_text(const RunTable& table) {
    std::string text;
    for (const auto& [name, value] : table.settings) text += fmt::format("# {}: {}\n", name, escaped(value));
    text += table.columns + "\n";
    for (const std::string& row : table.rows) text += row + "\n";
    return text;
}

RunTable read_run_table(const std::filesystem::path& path) {
    const std::string text = read_input_file(path, MAX_BYTES, "CSV");
    RunTable table;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::string_view rest = std::string_view(text).substr(begin);
        const bool has_columns = !table.columns.empty();
        const std::string line(has_columns ? first_csv_record(rest) : rest.substr(0, rest.find('\n')));
        begin += line.size() + 1;
        const std::size_t colon = line.find(": ");
        if (!has_columns && line.starts_with("# ") && colon != std::string::npos)
            table.settings.emplace_back(line.substr(2, colon - 2), unescaped(line.substr(colon + 2)));
        else if (!has_columns)
            table.columns = line;
        else
            table.rows.push_back(line);
        if (table.rows.size() > MAX_ROWS || table.settings.size() > MAX_SETTINGS ||
            (!has_columns && line.size() > MAX_SETTING_BYTES))
            throw Error(fmt::format(
                "'{}' has more than {} rows or {} settings, or a setting of more than {} MiB; give a CSV file that chart "
                "or stress wrote.",
                path.string(), MAX_ROWS, MAX_SETTINGS, MAX_SETTING_BYTES >> 20));
    }
    for (const char* name :
         {run_setting::COMMAND, run_setting::SCHEMA, run_setting::ROWS, run_setting::SHARD})
        if (setting(table.settings, name).empty())
            throw Error(fmt::format(
                "'{}' does not say to which run it belongs; give a CSV file that chart or stress wrote.",
                path.string()));
    return table;
}

RunSettings begin_settings(std::string_view command, int schema, std::size_t rows, const Shard& shard) {
    return {{run_setting::COMMAND, std::string(command)},
            {run_setting::SCHEMA, fmt::format("{}", schema)},
            {run_setting::VERSION, PROGRAM_VERSION},
            {run_setting::ROWS, fmt::format("{}", rows)},
            {run_setting::SHARD, shard_text(shard)}};
}

RunTable merge_shards(const std::vector<std::filesystem::path>& paths) {
    std::vector<RunTable> tables;
    std::size_t bytes = 0;
    for (const auto& path : paths) {
        bytes += bytes_of(tables.emplace_back(read_run_table(path)));
        if (bytes > MAX_BYTES)
            throw Error(fmt::format(
                "The files are larger than {} MiB together, the most that a table may have; merge fewer.",
                MAX_BYTES >> 20));
    }
    const RunTable& first = tables.front();
    const int count = parse_shard(setting(first.settings, run_setting::SHARD)).count;
    const auto row_count = parse_number<int>(setting(first.settings, run_setting::ROWS));
    if (!row_count || *row_count < 0)
        throw Error(
            fmt::format("'{}' does not say how many rows its run has; make it again.", paths[0].string()));
    std::vector<std::size_t> place_of(static_cast<std::size_t>(count), tables.size());  // file of each shard
    for (std::size_t i = 0; i < tables.size(); ++i) {
        const Shard shard = parse_shard(setting(tables[i].settings, run_setting::SHARD));
        auto difference = difference_of(tables[i].settings, first.settings, run_setting::SHARD);
        if (!difference && shard.count != count)
            difference = fmt::format("it is one of {} shards instead of {}", shard.count, count);
        if (!difference && tables[i].columns != first.columns) difference = "its columns differ";
        if (difference)
            throw Error(fmt::format("'{}' belongs to another run than '{}': {}; merge the shards of one run.",
                                    paths[i].string(), paths[0].string(), *difference));
        std::size_t& place = place_of[static_cast<std::size_t>(shard.index) - 1];
        if (place != tables.size())
            throw Error(fmt::format("'{}' and '{}' are both shard {}; give each shard once.",
                                    paths[place].string(), paths[i].string(), shard_text(shard)));
        place = i;
    }
    const auto rows = static_cast<std::size_t>(*row_count);
    const std::size_t shards = place_of.size();
    for (std::size_t i = 0; i < shards; ++i) {
        if (place_of[i] == tables.size())
            throw Error(fmt::format("Shard {}/{} is missing; give the files of all shards.", i + 1, count));
        const std::size_t wanted = (rows + shards - 1 - i) / shards;
        if (tables[place_of[i]].rows.size() != wanted)
            throw Error(fmt::format("'{}' has {} of the {} rows of its shard; run that shard again.",
                                    paths[place_of[i]].string(), tables[place_of[i]].rows.size(), wanted));
    }
    RunTable merged = {first.settings, first.columns, {}};
    for (std::size_t row = 0; row < rows; ++row)
        merged.rows.push_back(std::move(tables[place_of[row % shards]].rows[row / shards]));
    for (auto& [name, value] : merged.settings)
        if (name == run_setting::SHARD) value = shard_text({});
    return merged;
}

}  // namespace momentscope
