#include <fmt/format.h>

#include "app/chart_output.hpp"
#include "app/command.hpp"
#include "app/ignored_options.hpp"
#include "app/terminal.hpp"
#include "core/chart/chart.hpp"
#include "core/support/plain_text.hpp"

namespace momentscope {

namespace {

class Merge : public ParsedCommand {
public:
    explicit Merge(CLI::App& app) : ParsedCommand(app) {
        app.add_option("files", files_, "the .csv files of all shards of one run")->required();
        add_metric(app, metric_, "error of drawings: rmse, delta-e or flip [rmse]");
        app.add_option("-o,--output", output_, ".csv, or for a chart also .md, .svg, .html or .png")
            ->required();
        add_gl(app);
    }

    void refuse_ignored() const override {
        refuse_ignored_options(
            app(), {{"--metric", ends_in(output_, ".csv"), "in a .csv, because it has all metrics"},
                    {"--gl", !ends_in(output_, ".png"), "without a .png to draw"}});
    }

    FileUse files() const override { return {files_, {{"-o", output_}}}; }

    void run() const override {
        require_chart_output(output_);
        const std::vector<std::filesystem::path> files(files_.begin(), files_.end());
        const RunTable table = merge_shards(files);
        if (!ends_in(output_, ".csv"))
            for (const auto& file : files)
                chart_of(read_run_table(file), file.string());  // throws if a file is damaged
        write_chart(table, metric_, output_);
        print(fmt::format("{} rows in {}\n", table.rows.size(), one_line(output_)));
    }

private:
    std::vector<std::string> files_;
    Metric metric_ = Metric::rmse;
    std::string output_;
};

}  // namespace

std::unique_ptr<ParsedCommand> add_merge(CLI::App& app) {
    return std::make_unique<Merge>(app);
}

}  // namespace momentscope
