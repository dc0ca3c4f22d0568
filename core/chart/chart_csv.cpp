#include "core/chart/chart_csv.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "core/support/error.hpp"
#include "core/support/markup.hpp"
#include "core/support/parse_number.hpp"

namespace momentscope {

namespace {

constexpr std::size_t FIELDS = 20;
constexpr double MAX_NUMBER =
    std::numeric_limits<float>::max();  // errors are floats, and no time is that long
constexpr const char* COLUMNS =
    "scene,configuration,moments_ms,moments_range_ms,color_ms,color_range_ms,composite_ms,composite_range_ms,"
    "total_ms,total_range_ms,differential_ms,differential_range_ms,stored_bits,bits_with_factor,geometry_passes,rmse,delta_e,"
    "flip,stability,unavailable";

/// Reads one field after another. Throws Error at the first field that is not valid.
class Fields {
public:
    Fields(std::string_view line, std::string_view name)
        : fields_(csv_fields(line, FIELDS + 1)), name_(name) {
        if (fields_.size() != FIELDS) refuse(line);
    }
    std::string text() { return fields_[next_++]; }
    /// A finite number within +-MAX_NUMBER.
    double number() {
        const std::string& field = fields_[next_++];
        const auto value = parse_number<double>(field);
        if (!value || std::abs(*value) > MAX_NUMBER) refuse(field);
        return *value;
    }
    double at_least_zero() {
        const double value = number();
        if (value < 0) refuse(fields_[next_ - 1]);
        return value;
    }
    Spread spread() {
        const double median = at_least_zero();
        return {median, at_least_zero()};
    }
    Spread signed_spread() {
        const double median = number();
        return {median, at_least_zero()};
    }
    std::optional<int> count() {
        const std::string& field = fields_[next_++];
        if (field.empty()) return std::nullopt;
        const auto value = parse_number<int>(field);
        if (!value || *value < 0) refuse(field);
        return value;
    }
    bool at_numbers() const { return !fields_[next_].empty(); }
    void skip_to_last() { next_ = FIELDS - 1; }

private:
    [[noreturn]] void refuse(std::string_view what) const {
        constexpr int SHORT = 60;  // letters that are quoted; a record without its closing quote is long
        throw Error(
            fmt::format("'{}' is damaged at '{:.{}}'; remove it and make it again.", name_, what, SHORT));
    }

    std::vector<std::string> fields_;
    std::string_view name_;
    std::size_t next_ = 0;
};

std::string spread_text(const Spread& spread) {
    return fmt::format("{:.6g},{:.6g}", spread.median, spread.range);
}

std::string count_text(const std::optional<int>& count) {
    return count ? fmt::format("{}", *count) : "";
}

}  // namespace

std::string chart_columns() {
    return COLUMNS;
}

std::string chart_line(const ChartRow& row) {
    const std::string begin = fmt::format("{},{}", csv_quoted(row.scene), csv_quoted(row.configuration));
    if (!row.numbers) return begin + std::string(FIELDS - 2, ',') + csv_quoted(row.unavailable);
    const ChartNumbers& n = *row.numbers;
    return fmt::format("{},{},{},{},{},{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},", begin,
                       spread_text(n.moments), spread_text(n.color), spread_text(n.composite),
                       spread_text(n.total), spread_text(n.differential), count_text(n.stored_bits),
                       count_text(n.bits_with_factor), count_text(n.geometry_passes), n.rmse, n.delta_e,
                       n.flip, n.stability);
}

ChartRow parse_chart_line(std::string_view line, std::string_view name) {
    Fields fields(line, name);
    ChartRow row;
    row.scene = fields.text();
    row.configuration = fields.text();
    if (fields.at_numbers()) {
        ChartNumbers n;
        n.moments = fields.spread();
        n.color = fields.spread();
        n.composite = fields.spread();
        n.total = fields.spread();
        n.differential = fields.signed_spread();
        n.stored_bits = fields.count();
        n.bits_with_factor = fields.count();
        n.geometry_passes = fields.count();
        n.rmse = fields.at_least_zero();
        n.delta_e = fields.at_least_zero();
        n.flip = fields.at_least_zero();
        n.stability = fields.at_least_zero();
        row.numbers = n;
    }
    fields.skip_to_last();
    row.unavailable = fields.text();
    return row;
}

std::vector<ChartRow> chart_rows(const RunTable& table, std::string_view name) {
    if (setting(table.settings, run_setting::COMMAND) != "chart")
        throw Error(fmt::format("'{}' is a table of {}, not of chart; write it as .csv.", name,
                                setting(table.settings, run_setting::COMMAND)));
    const std::string schema = setting(table.settings, run_setting::SCHEMA);
    if (schema != fmt::format("{}", CHART_SCHEMA) || table.columns != COLUMNS)
        throw Error(
            fmt::format("'{}' has the columns of schema {}, and this version reads schema {}; make it again.",
                        name, schema, CHART_SCHEMA));
    std::vector<ChartRow> rows;
    for (const std::string& line : table.rows) rows.push_back(parse_chart_line(line, name));
    return rows;
}

}  // namespace momentscope
