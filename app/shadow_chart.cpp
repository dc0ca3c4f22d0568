#include "app/shadow_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "app/gl_context.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "core/bench/shadow_chart.hpp"
#include "core/support/error.hpp"
#include "core/support/output_file.hpp"

namespace momentscope {

namespace {

ShadowChartSettings settings_of(const ShadowChartOptions& options) {
    constexpr int MAX_ROUNDS = 100;
    ShadowChartSettings settings;
    settings.values = options.parameters.over();
    settings.size = options.size;
    settings.repeat = options.rounds;
    if (options.rounds > MAX_ROUNDS)
        throw Error(
            fmt::format("'{}' is not a number of rounds for --shadows; give a whole number from 1 to {}.",
                        options.rounds, MAX_ROUNDS));
    settings.techniques = {"fourier-7", "fourier-15", "power4-32", "power6-32"};
    if (options.parameters.has(ParameterId::shadow_technique)) {
        const std::string typed = parameter_text(parameter(ParameterId::shadow_technique),
                                                 settings.values[ParameterId::shadow_technique]);
        if (typed == "deep" || typed == "none")
            throw Error(
                "The chart of shadows already measures deep and none for comparison; give another --shadow-technique.");
        settings.techniques = {"fourier-7"};
        if (typed != "fourier-7") settings.techniques.push_back(typed);
    }
    settings.map_sizes = {1024, 2048};
    if (options.parameters.has(ParameterId::shadow_size))
        settings.map_sizes = {settings.values.count(ParameterId::shadow_size)};
    return settings;
}

}  // namespace

void run_shadow_chart(const ShadowChartOptions& options) {
    const ShadowChartSettings settings = settings_of(options);
    const std::filesystem::path path = options.output;
    const bool csv = path.extension() == ".csv";
    if (!path.empty() && !csv && path.extension() != ".md")
        throw Error("A chart of shadows is a .csv or .md file; give -o such a name.");
    if (!path.empty()) require_writable(path);
    const std::vector<std::string>& scenes = options.scenes;
    const auto context = make_headless_context({16, 16});
    Progress progress("Chart of shadows");
    std::vector<ShadowRow> rows;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const Scene scene = load_scene_and_warn(scenes[i], settings.values, progress);
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
