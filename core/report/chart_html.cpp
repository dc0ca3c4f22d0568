#include "core/report/chart_html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/report/chart_drawing.hpp"
#include "core/report/page_files.hpp"
#include "core/scene/scenes.hpp"
#include "core/support/json_text.hpp"
#include "core/support/markup.hpp"
#include "core/techniques/configuration.hpp"

namespace momentscope {

namespace {

using nlohmann::json;

std::string shell_quoted(const std::string& text) {
    constexpr std::string_view PLAIN = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=";
    if (text.find_first_not_of(PLAIN) == std::string::npos) return text;
    std::string quoted = "'";
    for (const char letter : text) quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    return quoted + "'";
}

json json_of(const Spread& spread) {
    return {spread.median, spread.range};
}

// Escapes JSON so that no string in it can end the surrounding script element.
std::string script_text(const json& value) {
    std::string text;
    for (const char letter : json_text(value))
        text += letter == '<' ? std::string("\\u003c") : std::string(1, letter);
    return text;
}

json json_of(const Chart& chart, const ChartRow& row) {
    const ChartNumbers n = row.numbers.value_or(ChartNumbers());
    return {{"scene", markup_escaped(row.scene)},
            {"configuration", markup_escaped(row.configuration)},
            {"command", explore_command(chart, row)},
            {"moments", json_of(n.moments)},
            {"color", json_of(n.color)},
            {"composite", json_of(n.composite)},
            {"total", json_of(n.total)},
            {"differential", json_of(n.differential)},
            {"stored", n.stored_bits ? json(*n.stored_bits) : json()},
            {"bits", n.bits_with_factor ? json(*n.bits_with_factor) : json()},
            {"passes", n.geometry_passes ? json(*n.geometry_passes) : json()},
            {"rmse", n.rmse},
            {"delta_e", n.delta_e},
            {"flip", n.flip},
            {"stability", n.stability}};
}

// The titles of all rows of a page.
std::vector<std::string> titles_of(const Chart& chart) {
    std::vector<std::string> titles;
    for (const ChartRow& row : chart.rows) titles.push_back(row.configuration);
    return titles;
}

// The drawing of a scene as SVG. titles: those of all rows of the page.
std::string scene_svg(const Chart& chart, std::span<const ChartRow> rows, Metric metric,
                      const std::vector<std::string>& titles) {
    Drawing drawing = chart_drawing(rows, metric, setting(chart.settings, "times"));
    const auto first = static_cast<std::size_t>(rows.data() - chart.rows.data());
    for (Drawing::Mark& mark : drawing.marks)
        if (mark.row != Drawing::NO_ROW) mark.row += first;
    return drawing_to_svg(drawing, titles);
}

std::string unavailable_text(std::span<const ChartRow> rows) {
    std::string text;
    for (const ChartRow& row : rows)
        if (!row.numbers)
            text += fmt::format("<li><code>{}</code> {}</li>\n", markup_escaped(row.configuration),
                                markup_escaped(row.unavailable));
    return text.empty() ? "" : fmt::format("<p>Without numbers:</p><ul>{}</ul>\n", text);
}

}  // namespace

std::string explore_command(const Chart& chart, const ChartRow& row) {
    std::string command =
        fmt::format("momentscope explore --scene {} {}", shell_quoted(absolute_scene(row.scene)),
                    configuration_options(parse_configuration(row.configuration)));
    std::istringstream parameters(setting(chart.settings, "parameters"));
    for (std::string one; parameters >> one;) {
        const std::size_t equals = one.find('=');
        const Parameter* known =
            equals == std::string::npos ? nullptr : find_parameter(one.substr(0, equals));
        if (known != nullptr && one.substr(equals + 1) != parameter_text(*known, known->default_value))
            command += fmt::format(" --{} {}", known->key, shell_quoted(one.substr(equals + 1)));
    }
    return command;
}

std::string chart_to_svg(const Chart& chart, Metric metric) {
    const std::vector<std::string> titles = titles_of(chart);
    std::string parts;
    float width = 0, height = 0;
    for (const std::span<const ChartRow> rows : scenes_of(chart)) {
        const Drawing drawing = chart_drawing(rows, metric, setting(chart.settings, "times"));
        parts += fmt::format("<g transform=\"translate(0 {})\">\n{}</g>\n", height,
                             scene_svg(chart, rows, metric, titles));
        width = std::max(width, drawing.size.x);
        height += drawing.size.y;
    }
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n{2}</svg>\n",
        width, height, parts);
}

std::string chart_to_html(const Chart& chart, Metric metric) {
    const std::vector<std::string> titles = titles_of(chart);
    std::string drawings, choices;
    json rows = json::array();
    for (const ChartRow& row : chart.rows) rows.push_back(json_of(chart, row));
    for (const MetricRow& row : metrics())
        choices +=
            fmt::format("<label title=\"{}\"><input type=radio name=metric value={}{}> {}</label>\n",
                        markup_escaped(row.help), row.key, row.id == metric ? " checked" : "", row.name);
    for (const std::span<const ChartRow> scene : scenes_of(chart)) {
        for (const MetricRow& row : metrics())
            drawings +=
                fmt::format("<div class={}>{}</div>\n", row.key, scene_svg(chart, scene, row.id, titles));
        drawings += unavailable_text(scene);
    }
    const auto& files = page_files();
    return fmt::format(fmt::runtime(files.at("chart.html")), fmt::arg("style", files.at("chart.css")),
                       fmt::arg("metric", metrics()[static_cast<std::size_t>(metric)].key),
                       fmt::arg("method", markup_escaped(chart_method(chart))), fmt::arg("choices", choices),
                       fmt::arg("drawings", drawings), fmt::arg("rows", script_text(rows)),
                       fmt::arg("script", files.at("chart.js")));
}

}  // namespace momentscope
