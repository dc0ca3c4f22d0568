#include "core/chart/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>

#include "core/chart/chart_csv.hpp"
#include "core/chart/pareto.hpp"
#include "core/support/markup.hpp"
#include "core/support/plain_text.hpp"

namespace momentscope {

namespace {

std::string count_text(const std::optional<int>& count, const char* otherwise) {
    return count ? fmt::format("{}", *count) : otherwise;
}

std::string table_line(const ChartRow& row, bool on_front) {
    const std::string name = fmt::format("{0}{1}{0}", on_front ? "**" : "", markdown_code(row.configuration));
    if (!row.numbers)
        return fmt::format("| {} | {} | | | | | | | | | | | |\n", name, markdown_cell(row.unavailable));
    const ChartNumbers& n = *row.numbers;
    return fmt::format(
        "| {} | {:.1f} | {:.1f} | {:.1f} | {:.1f} ({:.1f}) | {:.1f} ({:.1f}) | {} | {} | {} | {:.4f} | {:.2f} | {:.4f} | "
        "{:.1e} |\n",
        name, n.moments.median, n.color.median, n.composite.median, n.total.median, n.total.range,
        n.differential.median, n.differential.range, count_text(n.stored_bits, "grows"),
        count_text(n.bits_with_factor, "grows"), count_text(n.geometry_passes, "layers"), n.rmse, n.delta_e,
        n.flip, n.stability);
}

}  // namespace

Chart chart_of(const RunTable& table, std::string_view name) {
    return {table.settings, chart_rows(table, name)};
}

std::vector<std::span<const ChartRow>> scenes_of(const Chart& chart) {
    std::vector<std::span<const ChartRow>> scenes;
    for (std::size_t begin = 0; begin < chart.rows.size();) {
        std::size_t end = begin;
        while (end < chart.rows.size() && chart.rows[end].scene == chart.rows[begin].scene) ++end;
        scenes.push_back(std::span(chart.rows).subspan(begin, end - begin));
        begin = end;
    }
    return scenes;
}

double error_of(const ChartNumbers& numbers, Metric metric) {
    switch (metric) {
        case Metric::rmse:
            return numbers.rmse;
        case Metric::delta_e:
            return numbers.delta_e;
        case Metric::flip:
            break;
    }
    return numbers.flip;
}

std::vector<std::size_t> front_of(std::span<const ChartRow> rows, Metric metric) {
    constexpr double NONE = std::numeric_limits<double>::infinity();
    std::vector<glm::dvec2> points;
    for (const ChartRow& row : rows)
        points.push_back(row.numbers ? glm::dvec2(row.numbers->total.median, error_of(*row.numbers, metric))
                                     : glm::dvec2(NONE));
    return pareto_front(points);
}

std::string chart_method(const Chart& chart) {
    const auto text = [&](const char* name) { return one_line(setting(chart.settings, name)); };
    return fmt::format(
        "Pictures of {} pixels by Momentscope {} on {}. Times are in milliseconds, {}: medians of {} rounds, in which "
        "configurations take turns, with the range from the lower to the upper quartile in parentheses. Total is the sum "
        "of a technique's passes, and the difference is to `unsorted` in the same round. Errors are against `sorted`. "
        "Stability is the greatest change of the RMSE from one picture to the next along {}.",
        text("size"), text(run_setting::VERSION), text("gl"), text("times"), text("repeat"),
        text("camera path"));
}

std::string short_name(const std::string& configuration) {
    const std::size_t colon = configuration.find(':');
    std::string name = configuration.substr(0, colon);
    for (std::size_t begin = colon; begin < configuration.size();) {
        const std::size_t end = std::min(configuration.find(',', begin + 1), configuration.size());
        const std::string setting = configuration.substr(begin + 1, end - begin - 1);
        const std::string value = setting.substr(std::min(setting.find('=') + 1, setting.size()));
        const bool number = value.find_first_not_of("-+.0123456789e") == std::string::npos;
        name += " " + (number ? setting : value);
        begin = end;
    }
    return name;
}

std::string chart_to_markdown(const Chart& chart, Metric metric) {
    std::string text = fmt::format("# Speed against accuracy\n\n{}\n", chart_method(chart));
    for (const std::span<const ChartRow> rows : scenes_of(chart)) {
        fmt::format_to(
            std::back_inserter(text),
            "\n## {}\n\nBold: on the Pareto front of total time and {}.\n\n"
            "| configuration | pass 1 | pass 2 | composite | total | difference | stored bits | bits with factor | "
            "geometry passes | RMSE | ΔE | FLIP | stability |\n|---|{}\n",
            markdown_code(rows.front().scene), metrics()[static_cast<std::size_t>(metric)].symbol,
            "---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|");
        const std::vector<std::size_t> front = front_of(rows, metric);
        for (std::size_t i = 0; i < rows.size(); ++i)
            text += table_line(rows[i], std::ranges::find(front, i) != front.end());
    }
    return text;
}

}  // namespace momentscope
