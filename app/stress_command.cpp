#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "app/command.hpp"
#include "app/ignored_options.hpp"
#include "app/progress.hpp"
#include "app/stress_picture.hpp"
#include "app/terminal.hpp"
#include "core/report/stress_report.hpp"
#include "core/support/error.hpp"
#include "core/support/output_file.hpp"
#include "core/techniques/moment_kernel.hpp"

namespace momentscope {

namespace {

std::string report_text(const std::filesystem::path& path, const std::vector<StressCell>& cells,
                        const StressOptions& stress) {
    return path.extension() == ".csv" ? run_table_text(stress_table(cells, stress))
                                      : stress_to_html(cells, stress);
}

class StressCommand : public ParsedCommand {
public:
    explicit StressCommand(CLI::App& app) : ParsedCommand(app) {
        add_techniques(app, techniques_, "ids of techniques with moments [all]");
        app.add_option("--condition", conditions_, "ids of conditions (momentscope list conditions) [all]");
        add_count(app, "--rays", rays_, "number of random rays for each technique and condition", RAY_COUNT);
        add_seed(app, seed_);
        add_shard(app, shard_);
        app.add_option("-o,--output", output_, ".csv, .html or .png (a heat map)");
        parameters_.add_to(app);
        add_gl(app);
    }

    void refuse_ignored() const override {
        refuse_ignored_options(app(), {{"--gl", !ends_in(output_, ".png"), "without a .png to draw"}});
        refuse_ignored_parameters(parameters_,
                                  {.techniques = {}, .others = reconstruction_parameters(techniques())});
    }

    FileUse files() const override { return {{}, {{"-o", output_}}}; }

    void run() const override {
        const StressOptions stress = settings();
        const std::filesystem::path path = output_;
        const std::string kind = path.extension().string();
        if (!path.empty() && kind != ".csv" && kind != ".html" && kind != ".png")
            throw Error(
                fmt::format("'{}' does not end in .csv, .html or .png; give -o such a name.", path.string()));
        if (stress.shard.count > 1 && kind != ".csv")
            throw Error(
                "A shard is a part of a table; give -o a name that ends in .csv, and merge the shards later.");
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

private:
    std::vector<const Technique*> techniques() const {
        return techniques_.empty() ? moment_based_techniques() : techniques_of(techniques_, "");
    }

    StressOptions settings() const {
        StressOptions stress;
        stress.techniques = techniques();
        for (const Technique* technique : stress.techniques)
            if (!technique->has_moments())
                throw Error(fmt::format("'{}' has no moments, so no reconstruction can fail; leave it out.",
                                        technique->id));
        for (const Condition& condition : conditions())
            if (conditions_.empty()) stress.conditions.push_back(&condition);
        for (const std::string& id : split_list(conditions_))
            stress.conditions.push_back(&require_condition(id));
        stress.values = parameters_.over();
        refuse_nonsense(stress.techniques, stress.values);
        stress.rays = rays_;
        stress.seed = seed_;
        stress.shard = shard_;
        return stress;
    }

    TechniqueIds techniques_;
    std::vector<std::string> conditions_;
    int rays_ = 400;
    std::uint32_t seed_ = 1;
    Shard shard_;
    std::string output_;
    ParameterOptions parameters_;
};

}  // namespace

std::unique_ptr<ParsedCommand> add_stress(CLI::App& app) {
    return std::make_unique<StressCommand>(app);
}

}  // namespace momentscope
