// chart_run.hpp -- a whole chart: scenes times configurations, block by block, so that little is lost when it
// is ended.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "core/chart/measure.hpp"
#include "core/gl/gl_info.hpp"
#include "core/table/run_table.hpp"

namespace momentscope {

struct ChartPlan {
    std::vector<std::string> scenes;    // each once
    std::vector<std::string> contents;  // scene_content of each, or none when all are built in
    std::vector<Configuration> configurations;
    ChartSettings settings;
    Shard shard;
};

/// What makes two charts comparable row by row.
RunSettings chart_settings(const ChartPlan& plan, const GlInfo& gl);

/// The scene_content of the scene that comes after so many others in a chart; empty where it does not tell.
std::string charted_content(const RunSettings& settings, std::size_t scene);

/// What a chart asks of its surroundings.
struct ChartHooks {
    std::function<Scene(const std::string& id)> load;
    std::function<void(const RunTable& table)> keep;                  // after every block: the rows so far
    std::function<void(std::size_t done, std::size_t all)> progress;  // of what was still to be done
};

/// Measures the rows of the plan's shard that `kept` lacks, and returns all in the order of scenes and their
/// configurations; fewer when it was stopped. `kept` has the settings of this plan.
RunTable run_chart(const ChartPlan& plan, const RunTable& kept, const std::stop_token& stop,
                   const ChartHooks& hooks);

}  // namespace momentscope
