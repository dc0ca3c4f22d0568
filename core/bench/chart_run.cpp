#include "core/bench/chart_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <sstream>

#include "core/chart/camera_path.hpp"
#include "core/chart/chart_csv.hpp"

namespace momentscope {

namespace {

// Configurations that are timed in turn. With more of them, more would share the same noise, and more would
// be lost if the run is ended.
constexpr std::size_t BLOCK = 6;
constexpr const char* MESH_CONTENT = "mesh content";  // a setting, so rows of another mesh are not accepted

/// The rows of a run by their places in it.
using Rows = std::map<std::size_t, std::string>;

std::string texts_of(const std::vector<Configuration>& configurations) {
    std::vector<std::string> texts;
    for (const Configuration& one : configurations) texts.push_back(configuration_text(one));
    return fmt::format("{}", fmt::join(texts, " "));
}

std::string parameters_text(const ParameterValues& values) {
    std::string text;
    for (const ParameterId id : CHART_PARAMETERS)
        text += fmt::format("{}{}={}", text.empty() ? "" : " ", parameter(id).key,
                            parameter_text(parameter(id), values[id]));
    return text;
}

Rows rows_of(const ChartPlan& plan, const RunTable& table) {
    std::map<std::pair<std::string, std::string>, std::string> lines;
    for (const std::string& line : table.rows) {
        const ChartRow row = parse_chart_line(line, "the unfinished chart");
        lines[{row.scene, row.configuration}] = line;
    }
    Rows rows;
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene)
        for (std::size_t i = 0; i < plan.configurations.size(); ++i) {
            const auto line = lines.find({plan.scenes[scene], configuration_text(plan.configurations[i])});
            if (line != lines.end()) rows[scene * plan.configurations.size() + i] = line->second;
        }
    return rows;
}

/// The places of those rows of a scene that are not measured yet.
std::vector<std::size_t> missing_places(const ChartPlan& plan, std::size_t scene, const Rows& rows) {
    std::vector<std::size_t> missing;
    for (std::size_t i = 0; i < plan.configurations.size(); ++i) {
        const std::size_t place = scene * plan.configurations.size() + i;
        if (plan.shard.holds(place) && !rows.contains(place)) missing.push_back(place);
    }
    return missing;
}

RunTable table_of(const RunSettings& settings, const Rows& rows) {
    RunTable table = {settings, chart_columns(), {}};
    for (const auto& [place, line] : rows) table.rows.push_back(line);
    return table;
}

}  // namespace

RunSettings chart_settings(const ChartPlan& plan, const GlInfo& gl) {
    RunSettings settings =
        begin_settings("chart", CHART_SCHEMA, plan.scenes.size() * plan.configurations.size(), plan.shard);
    settings.insert(settings.end(),
                    {{"size", fmt::format("{}x{}", plan.settings.size.x, plan.settings.size.y)},
                     {"repeat", fmt::format("{}", plan.settings.repeat)},
                     {"scenes", fmt::format("{}", fmt::join(plan.scenes, " "))},
                     {"configurations", texts_of(plan.configurations)},
                     {"parameters", parameters_text(plan.settings.values)},
                     {"camera path", PATH_TEXT},
                     {"times", timing_text(reliable_timing(gl))},
                     {"gl", gl.renderer}});
    if (!plan.contents.empty())
        settings.emplace_back(MESH_CONTENT, fmt::format("{}", fmt::join(plan.contents, " ")));
    return settings;
}

std::string charted_content(const RunSettings& settings, std::size_t scene) {
    std::istringstream contents(setting(settings, MESH_CONTENT));
    std::string content;
    for (std::size_t i = 0; i <= scene; ++i)
        if (!(contents >> content)) return "";
    return content;
}

RunTable run_chart(const ChartPlan& plan, const RunTable& kept, const std::stop_token& stop,
                   const ChartHooks& hooks) {
    Rows rows = rows_of(plan, kept);
    std::size_t all = 0;
    std::size_t done = 0;
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene)
        all += chart_steps(missing_places(plan, scene, rows).size(), plan.settings);
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
        const std::vector<std::size_t> missing = missing_places(plan, scene, rows);
        if (missing.empty()) continue;
        ChartBench bench(hooks.load(plan.scenes[scene]), plan.settings);
        for (std::size_t begin = 0; begin < missing.size() && !stop.stop_requested(); begin += BLOCK) {
            const auto places = std::span(missing).subspan(begin, std::min(BLOCK, missing.size() - begin));
            std::vector<Configuration> block;
            for (const std::size_t place : places)
                block.push_back(plan.configurations[place % plan.configurations.size()]);
            const auto measured = bench.measure(block, stop, [&] { hooks.progress(++done, all); });
            for (std::size_t i = 0; i < measured.size(); ++i) rows[places[i]] = chart_line(measured[i]);
            if (!measured.empty()) hooks.keep(table_of(kept.settings, rows));
        }
    }
    return table_of(kept.settings, rows);
}

}  // namespace momentscope
