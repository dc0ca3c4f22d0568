#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "app/command.hpp"
#include "app/gl_context.hpp"
#include "app/ignored_options.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "core/bench/chart_run.hpp"
#include "core/bench/held_out.hpp"
#include "core/report/advice_text.hpp"
#include "core/scene/scene_content.hpp"
#include "core/support/error.hpp"
#include "core/support/output_file.hpp"
#include "ui/model/session.hpp"

namespace momentscope {

namespace {

constexpr int MAX_BITS = 1'000'000;

/// The rows of one scene, and everything that is needed to draw their pictures again.
struct Evidence {
    std::vector<ChartRow> rows;
    glm::ivec2 size{0};
    ParameterValues values;  // parameters of all pictures
    Scene scene;
};

// Parses "order=reversed order-seed=1 opacity=0.4", the form in a chart's settings.
ParameterValues values_of(const std::string& text) {
    ParameterValues values;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        const std::string_view setting = std::string_view(text).substr(begin, end - begin);
        const std::size_t equals = setting.find('=');
        const Parameter* row = find_parameter(setting.substr(0, equals));
        if (row == nullptr || equals == std::string_view::npos)
            throw Error(
                fmt::format("The chart has a parameter '{}' that this version does not know; make the chart "
                            "again.",
                            setting));
        values.set(row->id, parse_parameter(*row, setting.substr(equals + 1)));
        begin = end + 1;
    }
    return values;
}

Advice checked(const Evidence& evidence, const AdviceBounds& bounds, HeldOutErrors& held_out) {
    Progress progress("Advice at other views");
    const auto context = make_headless_context({16, 16});
    HeldOutViews views(evidence.scene, evidence.size, evidence.values);
    std::size_t done = 0;
    const auto advice = checked_advice(evidence.rows, bounds, held_out, [&](std::size_t row) {
        const Configuration configuration =
            parse_configuration(evidence.rows[row].configuration, evidence.values);
        std::optional<double> worst;
        for (std::size_t view = 0; view < views.count(); ++view) {
            if (progress.stop().stop_requested()) return std::optional<double>();
            const double error = views.error(configuration, view, bounds.metric, progress.stop());
            worst = std::max(worst.value_or(0), error);
        }
        progress.show(++done, evidence.rows.size());
        return worst;
    });
    progress.require_finished();
    assert(advice);
    return *advice;
}

class Advise : public ParsedCommand {
public:
    explicit Advise(CLI::App& app) : ParsedCommand(app) {
        add_scene(app, scene_);
        const auto bound = [&](const char* name, const char* help, const char* what,
                               std::optional<double>& value) {
            return add_parsed<std::optional<double>>(
                app, name, value, help, [what](const std::string& text) { return parse_bound(text, what); });
        };
        bound("--max-error", "greatest error against sorted that is accepted", "greatest error", max_error_)
            ->required();
        add_metric(app, bounds_.metric, "of the error: rmse, delta-e or flip [rmse]");
        add_parsed<std::optional<int>>(app, "--max-bits", bounds_.max_bits,
                                       "greatest number of bits per pixel, without the colour buffers",
                                       [](const std::string& text) {
                                           return parse_count(text, "number of bits per pixel", 1, MAX_BITS);
                                       });
        bound("--max-ms", "longest time of the passes of a technique in milliseconds", "time in milliseconds",
              bounds_.max_ms);
        app.add_flag("--order-independent", bounds_.order_independent,
                     "leave out techniques that depend on the order of submission");
        CLI::Option* size = add_size(app, size_);
        add_gl(app);
        add_techniques(app, techniques_,
                       "ids of techniques, or single configurations such as at:nodes=8 [all]");
        CLI::Option* rounds = add_rounds(app, rounds_);
        app.add_option("--chart", chart_,
                       "a .csv of momentscope chart, whose rows are used instead of new ones")
            ->excludes(size, rounds);
        app.add_option("-o,--output", output_,
                       "where to write the recipe as .json; explore --session opens it");
        parameters_.add_to(app);
    }

    void refuse_ignored() const override {
        if (!chart_.empty()) return;  // --chart takes no parameters; run() says so
        refuse_ignored_parameters(
            parameters_,
            {.techniques = techniques_in(charted_configurations(techniques_, parameters_.over())),
             .picture = true,
             .order = true,
             .mesh = has_mesh_file(scene_)});
    }

    FileUse files() const override {
        FileUse use = {scene_files(scene_), {{"-o", output_}}};
        use.inputs.push_back(chart_);
        return use;
    }

    void run() const override {
        AdviceBounds bounds = bounds_;
        bounds.max_error = *max_error_;
        require_sensible(bounds);
        ui::require_session_name(scene_);
        if (!output_.empty()) {
            if (!ends_in(output_, ".json"))
                throw Error(fmt::format("A recipe is a .json file; '{}' is not.", output_));
            require_writable(output_);
        }
        const Evidence evidence = chart_.empty() ? measured_evidence() : read_evidence();
        HeldOutErrors held_out(evidence.rows.size());
        const Advice advice = checked(evidence, bounds, held_out);
        if (!advice.winner) throw Error(no_advice_text(evidence.rows, bounds, held_out, advice));
        print(fmt::format("{}, {}x{}: {}, also at views turned by {}\n\n{}", one_line(scene_),
                          evidence.size.x, evidence.size.y, bounds_text(bounds), HELD_OUT_TEXT,
                          advice_text(evidence.rows, bounds, held_out, advice)));
        const ui::ExplorerState state =
            recipe(parse_configuration(evidence.rows[*advice.winner].configuration, evidence.values));
        if (output_.empty()) {
            print("\n" + ui::session_text(state));
            return;
        }
        ui::write_session_file(state, output_);
        print(fmt::format("\nmomentscope explore --session {} opens it.\n", one_line(output_)));
    }

private:
    Evidence read_evidence() const {
        if (!parameters_.empty())
            throw Error(
                "The rows of a chart keep the parameters they were measured with; give no parameters, or leave "
                "--chart out.");
        const Chart chart = chart_of(read_run_table(chart_), chart_);
        const std::string shard = setting(chart.settings, run_setting::SHARD);
        if (shard != shard_text({}))
            throw Error(fmt::format(
                "'{}' is only shard {} of a chart; merge all shards with momentscope merge.", chart_, shard));
        Evidence evidence = {{},
                             parse_size(setting(chart.settings, "size")),
                             values_of(setting(chart.settings, "parameters")),
                             {}};
        const auto scenes = scenes_of(chart);
        const auto found = std::ranges::find_if(scenes, [&](const std::span<const ChartRow> rows) {
            return absolute_scene(rows.front().scene) == absolute_scene(scene_);
        });
        if (found != scenes.end()) evidence.rows.assign(found->begin(), found->end());
        if (evidence.rows.empty())
            throw Error(fmt::format("'{}' has no rows of the scene '{}', only of {}; chart that scene, too.",
                                    chart_, scene_, setting(chart.settings, "scenes")));
        Progress progress("Advice");
        evidence.scene = load_scene_and_warn(scene_, evidence.values, progress);
        const auto place = static_cast<std::size_t>(found - scenes.begin());
        const std::string content = charted_content(chart.settings, place);
        if (!content.empty() && content != scene_content(evidence.scene))
            throw Error(fmt::format("The mesh file '{}' has changed since '{}' was made; chart it again.",
                                    scene_, chart_));
        if (techniques_.empty()) return evidence;
        std::vector<std::string> wanted;
        for (const Configuration& one : charted_configurations(techniques_, evidence.values))
            wanted.push_back(configuration_text(one));
        std::erase_if(evidence.rows, [&](const ChartRow& row) {
            return std::ranges::find(wanted, row.configuration) == wanted.end();
        });
        if (evidence.rows.empty())
            throw Error(fmt::format("'{}' has no rows of these techniques; chart them, too.", chart_));
        return evidence;
    }

    Evidence measured_evidence() const {
        ChartPlan plan;
        plan.settings = {size_, rounds_, parameters_.over()};
        plan.scenes = {scene_};
        plan.configurations = charted_configurations(techniques_, plan.settings.values);
        Progress progress("Advice");
        Scene scene = load_scene_and_warn(scene_, plan.settings.values, progress);
        const auto context = make_headless_context({16, 16});
        const ChartHooks hooks = {[&](const std::string&) { return scene; }, [](const RunTable&) {},
                                  [&](std::size_t done, std::size_t all) { progress.show(done, all); }};
        const RunTable table =
            run_chart(plan, {chart_settings(plan, gl_info(capabilities())), {}, {}}, progress.stop(), hooks);
        progress.require_finished();
        return {chart_of(table, "the chart").rows, plan.settings.size, plan.settings.values,
                std::move(scene)};
    }

    ui::ExplorerState recipe(const Configuration& configuration) const {
        ui::ExplorerState state;
        state.scene = absolute_scene(scene_);
        state.technique = configuration.technique;
        state.parameters = configuration.values;
        state.compare.metric = bounds_.metric;
        return state;
    }

    std::string scene_ = STANDARD_SCENE;
    std::optional<double> max_error_;
    AdviceBounds bounds_;  // all bounds but the one on the error
    glm::ivec2 size_ = {320, 180};
    TechniqueIds techniques_;
    int rounds_ = 3;
    std::string chart_;
    std::string output_;
    ParameterOptions parameters_;
};

}  // namespace

std::unique_ptr<ParsedCommand> add_advise(CLI::App& app) {
    return std::make_unique<Advise>(app);
}

}  // namespace momentscope
