#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "app/commands.hpp"
#include "app/progress.hpp"
#include "app/stress_picture.hpp"
#include "app/terminal.hpp"
#include "core/error.hpp"
#include "core/output_file.hpp"
#include "core/stress/stress_report.hpp"
#include "core/techniques/moment_kernel.hpp"

namespace momentscope {

namespace {

std::string report_text(const std::filesystem::path& path, const std::vector<StressCell>& cells,
                        const StressOptions& stress) {
    return path.extension() == ".csv" ? run_table_text(stress_table(cells, stress))
                                      : stress_to_html(cells, stress);
}

}  // namespace

void run_stress_command(const Options& options) {
    StressOptions stress;
    stress.techniques = moment_based_techniques();
    if (!options.techniques.empty()) stress.techniques = parse_techniques(options, "");
    for (const Technique* technique : stress.techniques)
        if (technique->kernel == nullptr)
            throw Error(fmt::format("'{}' has no moments, so no reconstruction could fail; leave it out.",
                                    technique->id));
    for (const Condition& condition : conditions())
        if (options.conditions.empty()) stress.conditions.push_back(&condition);
    for (const std::string& id : split_list(options.conditions))
        stress.conditions.push_back(&require_condition(id));
    stress.values = parse_parameters(options);
    stress.rays = parse_ray_count(options.rays);
    stress.seed = parse_seed(options.seed);
    const std::filesystem::path path = options.output;
    const std::string kind = path.extension().string();
    if (!path.empty() && kind != ".csv" && kind != ".html" && kind != ".png")
        throw Error(fmt::format("'{}' is neither .csv, .html nor .png.", path.string()));
    stress.shard = parse_shard(options.shard);
    if (stress.shard.count > 1 && kind != ".csv")
        throw Error("A shard is a part of a table; give -o a name that ends in .csv.");
    if (!path.empty()) require_writable(path);
    std::vector<StressCell> cells;
    {
        Progress progress("Stress");
        cells = run_stress(stress, progress.stop(),
                           [&](std::size_t done, std::size_t all) { progress.show(done, all); });
        progress.require_finished();
    }
    if (kind == ".png")
        write_stress_picture(cells, stress, path);
    else if (!path.empty())
        write_file(report_text(path, cells, stress), path);
    print(stress_to_text(cells));
}

}  // namespace momentscope
