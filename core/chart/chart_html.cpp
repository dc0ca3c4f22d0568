#include "core/chart/chart_html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/chart/chart_drawing.hpp"
#include "core/json_text.hpp"
#include "core/markup.hpp"
#include "core/scene/scenes.hpp"
#include "core/techniques/configuration.hpp"

namespace momentscope {

namespace {

using nlohmann::json;

constexpr const char* STYLE =
    "body{font:14px/1.5 'DejaVu Sans',Verdana,sans-serif;margin:2em;color:#222;background:#fff;max-width:1120px}"
    "svg{display:none;max-width:100%;height:auto}.rmse .rmse svg,.delta-e .delta-e svg,.flip .flip svg{display:block}"
    ".point{cursor:pointer}.point:hover *,.chosen *{stroke:#000;stroke-width:2.5}"
    "#details{position:sticky;bottom:0;background:#fff;border-top:2px solid #222;padding:.6em 0;min-height:5.5em}"
    "#name{position:absolute;display:none;background:#222;color:#fff;padding:2px 7px;border-radius:3px;font-size:12px;"
    "pointer-events:none}code{background:#f1f3f5;padding:2px 5px}label{margin-right:1.2em}td{padding:0 1.2em 0 0}";

constexpr const char* SCRIPT = R"(
const name = document.getElementById('name'), details = document.getElementById('details');
const cell = (head, text) => `<td>${head}<br><b>${text}</b></td>`;
const spread = s => `${s[0].toPrecision(4)} (${s[1].toPrecision(2)})`;
function show(row) {
  document.querySelectorAll('.chosen').forEach(one => one.classList.remove('chosen'));
  document.querySelectorAll(`.point[data-row="${row}"]`).forEach(one => one.classList.add('chosen'));
  const r = ROWS[row];
  details.innerHTML = '<table><tr></tr></table><code></code>';
  details.querySelector('tr').innerHTML = cell(r.scene, r.configuration) + cell('pass 1', spread(r.moments)) +
    cell('pass 2', spread(r.color)) + cell('composite', spread(r.composite)) + cell('total', spread(r.total)) +
    cell('difference', spread(r.differential)) + cell('stored bits', r.stored ?? 'grow') +
    cell('bits with factor', r.bits ?? 'grow') + cell('passes', r.passes ?? 'layers') +
    cell('RMSE', r.rmse) + cell('ΔE', r.delta_e) + cell('FLIP', r.flip) + cell('stability', r.stability);
  details.querySelector('code').textContent = r.command;
}
document.querySelectorAll('.point').forEach(point => {
  const row = point.dataset.row;
  point.querySelector('title').remove();
  point.addEventListener('mousemove', event => {
    name.textContent = `${ROWS[row].configuration}: ${ROWS[row].total[0].toPrecision(3)} ms`;
    name.style.cssText = `display:block;left:${event.pageX + 14}px;top:${event.pageY + 10}px`;
  });
  point.addEventListener('mouseleave', () => name.style.display = 'none');
  point.addEventListener('click', () => show(row));
});
document.querySelectorAll('input').forEach(input =>
  input.addEventListener('change', () => document.body.className = input.value));
)";

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
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=en><meta charset=utf-8><title>Momentscope: speed against accuracy</title>\n"
        "<style>{}</style>\n<body class={}>\n<h1>Speed against accuracy</h1>\n<p>{}</p>\n<p>{}</p>\n{}"
        "<div id=name></div>\n<div id=details>Click a mark for its numbers and for the command that opens it in the "
        "window.</div>\n<script>const ROWS = {};{}</script>\n</body>\n</html>\n",
        STYLE, metrics()[static_cast<std::size_t>(metric)].key, markup_escaped(chart_method(chart)), choices,
        drawings, script_text(rows), SCRIPT);
}

}  // namespace momentscope
