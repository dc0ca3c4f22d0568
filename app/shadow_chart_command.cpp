// shadow_chart_command.cpp -- chart --shadows: what shadows of transparent casters cost (Table 2 of the
// paper).
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "app/commands.hpp"
#include "app/gl_context.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "core/chart/shadow_chart.hpp"
#include "core/error.hpp"
#include "core/output_file.hpp"

namespace momentscope {

namespace {

ShadowChartSettings parse_settings(const Options& options) {
    ShadowChartSettings settings;
    settings.values = parse_parameters(options);
    settings.size = parse_size(options.size.empty() ? "640x360" : options.size);
    settings.repeat = parse_count(options.repeat, "number of rounds", 1, 100);
    const std::string& typed = options.parameters.at(parameter(ParameterId::shadow_technique).key);
    if (typed == "deep" || typed == "none")
        throw Error(
            "The chart of shadows compares with deep maps and with none; give another --shadow-technique.");
    settings.techniques = typed.empty()
                              ? std::vector<std::string>{"fourier-7", "fourier-15", "power4-32", "power6-32"}
                              : std::vector<std::string>{"fourier-7", typed};
    if (settings.techniques.back() == settings.techniques.front()) settings.techniques.resize(1);
    settings.map_sizes = {1024, 2048};
    if (!options.parameters.at(parameter(ParameterId::shadow_size).key).empty())
        settings.map_sizes = {static_cast<int>(*settings.values[ParameterId::shadow_size])};
    return settings;
}

}  // namespace

void run_shadow_chart(const Options& options, const std::vector<std::string>& scenes) {
    const ShadowChartSettings settings = parse_settings(options);
    const std::filesystem::path path = options.output;
    const bool csv = path.extension() == ".csv";
    if (!path.empty() && !csv && path.extension() != ".md")
        throw Error("A chart of shadows ends in .csv or .md; give -o such a name.");
    if (!path.empty()) require_writable(path);
    const auto context = make_gl_context("osmesa", {16, 16});
    Progress progress("Chart of shadows");
    std::vector<ShadowRow> rows;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const Scene scene = load_scene_and_warn(scenes[i], *settings.values[ParameterId::opacity], progress);
        const auto report = [&](std::size_t done, std::size_t all) {
            progress.show(i * all + done, scenes.size() * all);
        };
        std::ranges::move(measure_shadows(scene, settings, progress.stop(), report),
                          std::back_inserter(rows));
        progress.require_finished();
    }
    const std::string text = csv ? shadow_rows_to_csv(rows) : shadow_rows_to_markdown(rows);
    if (path.empty())
        print(text);
    else
        write_file(text, path);
}

}  // namespace momentscope
