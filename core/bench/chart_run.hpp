// chart_run.hpp -- runs a whole chart: all configurations on all scenes, block by block, so that little is
// lost if the run is ended.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "core/bench/measure.hpp"
#include "core/gl/gl_info.hpp"
#include "core/table/run_table.hpp"

namespace momentscope {

struct ChartPlan {
    std::vector<std::string> scenes;    // each only once
    std::vector<std::string> contents;  // scene_content of each; empty if all are built in
    std::vector<Configuration> configurations;
    ChartSettings settings;
    Shard shard;
};

/// The settings that must be equal so that two charts are comparable row by row.
RunSettings chart_settings(const ChartPlan& plan, const GlInfo& gl);

/// The scene_content of scene number `scene` of a chart; empty if the settings do not have it.
std::string charted_content(const RunSettings& settings, std::size_t scene);

/// Functions that a chart calls.
struct ChartHooks {
    std::function<Scene(const std::string& id)> load;
    std::function<void(const RunTable& table)> keep;                  // after every block: all rows so far
    std::function<void(std::size_t done, std::size_t all)> progress;  // of the rows that were still missing
};

/// Measures those rows of the shard of the plan that `kept` lacks. Returns all rows, in the order of scenes
/// and their configurations; fewer if stopped. `kept` must have the settings of this plan.
RunTable run_chart(const ChartPlan& plan, const RunTable& kept, const std::stop_token& stop,
                   const ChartHooks& hooks);

}  // namespace momentscope
