#include <fmt/format.h>

#include <algorithm>
#include <atomic>

#include "app/chart_output.hpp"
#include "app/command.hpp"
#include "app/gl_context.hpp"
#include "app/ignored_options.hpp"
#include "app/progress.hpp"
#include "app/shadow_chart.hpp"
#include "app/terminal.hpp"
#include "core/bench/chart_run.hpp"
#include "core/chart/chart.hpp"
#include "core/scene/scene_content.hpp"
#include "core/support/error.hpp"
#include "core/support/output_file.hpp"

namespace momentscope {

namespace {

std::vector<std::string> parse_scenes(const std::string& text) {
    std::vector<std::string> scenes;
    std::error_code code;
    if (text != "all" && std::filesystem::exists(text, code))
        return {text};  // a file whose name may have commas
    if (text == "all")
        for (const SceneEntry& entry : scene_entries()) scenes.emplace_back(entry.id);
    else
        for (const std::string& id : split_list({text}))
            if (std::ranges::find(scenes, id) == scenes.end()) scenes.push_back(id);
    return scenes;
}

/// The rows of an earlier run that was stopped. They are in a file of their own beside the output.
class UnfinishedChart {
public:
    explicit UnfinishedChart(const std::string& output) {
        if (output.empty()) return;
        constexpr std::size_t MAX_NAME = 200;  // bytes; a name may have 255, and a suffix is added
        const std::filesystem::path path(output);
        path_ = path.parent_path() / (path.filename().string().substr(0, MAX_NAME) + ".partial");
    }

    RunTable read(const RunSettings& settings) const {
        RunTable table = {settings, {}, {}};
        std::error_code code;
        if (path_.empty() || !std::filesystem::exists(path_, code)) return table;
        table = read_run_table(path_);
        if (const auto difference = difference_of(table.settings, settings))
            throw Error(fmt::format(
                "'{}' is an unfinished chart of another run: {}; finish that run, remove the file, "
                "or give another -o.",
                path_.string(), *difference));
        return table;
    }

    void write(const RunTable& table) const {
        if (!path_.empty()) write_file(run_table_text(table), path_);
    }

    void remove() const {
        std::error_code ignored;
        if (!path_.empty()) std::filesystem::remove(path_, ignored);
    }

    /// The message about the finished rows after the run was stopped.
    std::string how_to_go_on(std::size_t rows) const {
        if (path_.empty())
            return "The chart was stopped before it was finished; with -o, finished rows are kept.";
        if (rows == 0)
            return "The chart was stopped before its first rows were finished; nothing was written.";
        return fmt::format(
            "The chart was stopped; {} rows are kept in '{}', and the same command continues from there.",
            rows, path_.string());
    }

private:
    std::filesystem::path path_;
};

// Empty if all scenes are built in.
std::vector<std::string> contents_of(const std::vector<std::string>& scenes, float opacity,
                                     Progress& progress) {
    std::vector<std::string> contents;
    if (std::ranges::all_of(scenes, is_builtin_scene)) return contents;
    for (const std::string& id : scenes)
        contents.push_back(is_builtin_scene(id) ? BUILTIN_CONTENT
                                                : scene_content(load_scene_visibly(id, opacity, progress)));
    return contents;
}

// Loads the scene that the plan means. Fails if its file has changed while other scenes were measured.
Scene planned_scene(const ChartPlan& plan, const std::string& id, float opacity, Progress& progress) {
    Scene scene = load_scene_and_warn(id, opacity, progress);
    const auto place = static_cast<std::size_t>(std::ranges::find(plan.scenes, id) - plan.scenes.begin());
    if (!plan.contents.empty() && plan.contents[place] != scene_content(scene))
        throw Error(
            fmt::format("The mesh file '{}' changed while the chart was made; make the chart again.", id));
    return scene;
}

RunTable measured(ChartPlan plan, const UnfinishedChart& unfinished) {
    const float opacity = plan.settings.values.number(ParameterId::opacity);
    for (const std::string& id : plan.scenes) require_scene(id);
    std::atomic<std::size_t> rows = 0;
    Progress progress("Chart", [&] { return unfinished.how_to_go_on(rows); });
    plan.contents = contents_of(plan.scenes, opacity, progress);
    const auto context = make_headless_context({16, 16});
    const RunTable kept = unfinished.read(chart_settings(plan, gl_info(capabilities())));
    rows = kept.rows.size();
    const ChartHooks hooks = {
        [&](const std::string& id) { return planned_scene(plan, id, opacity, progress); },
        [&](const RunTable& table) {
            unfinished.write(table);
            rows = table.rows.size();
        },
        [&](std::size_t done, std::size_t all) { progress.show(done, all); }};
    RunTable table = run_chart(plan, kept, progress.stop(), hooks);
    progress.require_finished();
    return table;
}

class ChartCommand : public ParsedCommand {
public:
    explicit ChartCommand(CLI::App& app) : ParsedCommand(app) {
        app.add_option("--scene", scenes_,
                       "ids of scenes or paths of mesh files, separated by commas, or all")
            ->capture_default_str();
        add_size(app, size_);
        add_gl(app);
        add_techniques(app, techniques_,
                       "ids of techniques, or single configurations such as at:nodes=8 [all]");
        add_rounds(app, rounds_);
        add_metric(app, metric_, "error of drawings: rmse, delta-e or flip [rmse]");
        add_shard(app, shard_);
        app.footer(
            "With --shadows the chart measures the cost of shadows of transparent casters and writes .csv or .md. It reads "
            "--shadow-technique [fourier-7, fourier-15, power4-32 and power6-32] and --shadow-size [1024 and 2048].");
        app.add_option(
            "-o,--output", output_,
            ".csv, .md, .svg, .html or .png; a command that was stopped continues when it is run again");
        parameters_.add_to(app);
    }

    void refuse_ignored() const override {
        const ParameterValues values = parameters_.over();
        if (values.is_on(ParameterId::shadows)) {
            const char* shadows = "together with --shadows, because that chart has one error and no shards";
            refuse_ignored_options(
                app(),
                {{"--metric", true, shadows},
                 {"--shard", true, shadows},
                 {"--technique", true, "together with --shadows, where --shadow-technique takes its place"}});
            return refuse_ignored_parameters(
                parameters_, {.techniques = {}, .picture = true, .mesh = has_mesh_file(scenes_)});
        }
        refuse_ignored_options(
            app(), {{"--metric", ends_in(output_, ".csv"), "in a .csv, because it has all metrics"}});
        refuse_ignored_parameters(parameters_,
                                  {.techniques = techniques_in(charted_configurations(techniques_, values)),
                                   .picture = true,
                                   .order = true,
                                   .mesh = has_mesh_file(scenes_)});
    }

    FileUse files() const override { return {scene_files(scenes_), {{"-o", output_}}}; }

    void run() const override {
        if (parameters_.over().is_on(ParameterId::shadows))
            return run_shadow_chart({parse_scenes(scenes_), size_, rounds_, parameters_, output_});
        const std::filesystem::path path = output_;
        if (!path.empty()) require_chart_output(path);
        if (shard_.count > 1 && path.extension() != ".csv")
            throw Error(
                "A shard is a part of a table; give -o a name that ends in .csv, and merge the shards later.");
        const UnfinishedChart unfinished(output_);
        const RunTable table = measured(plan(), unfinished);
        if (path.empty()) {
            print(chart_to_markdown(chart_of(table, "the chart"), metric_));
            return;
        }
        write_chart(table, metric_, path);
        unfinished.remove();
        print(fmt::format("{} rows in {}\n", table.rows.size(), one_line(path.string())));
    }

private:
    ChartPlan plan() const {
        ChartPlan plan;
        plan.settings = {size_, rounds_, parameters_.over()};
        plan.scenes = parse_scenes(scenes_);
        plan.configurations = charted_configurations(techniques_, plan.settings.values);
        plan.shard = shard_;
        return plan;
    }

    std::string scenes_ = STANDARD_SCENE;
    glm::ivec2 size_ = {640, 360};
    TechniqueIds techniques_;
    int rounds_ = 3;
    Metric metric_ = Metric::rmse;
    Shard shard_;
    std::string output_;
    ParameterOptions parameters_;
};

}  // namespace

std::unique_ptr<ParsedCommand> add_chart(CLI::App& app) {
    return std::make_unique<ChartCommand>(app);
}

}  // namespace momentscope
