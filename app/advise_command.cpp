#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "app/commands.hpp"
#include "app/gl_context.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "core/chart/advice_text.hpp"
#include "core/chart/chart_run.hpp"
#include "core/chart/held_out.hpp"
#include "core/error.hpp"
#include "core/output_file.hpp"
#include "core/scene/scene_content.hpp"
#include "ui/session.hpp"

namespace momentscope {

namespace {

constexpr int MAX_BITS = 1'000'000;

AdviceBounds parse_bounds(const Options& options) {
    AdviceBounds bounds;
    bounds.metric = require_metric(options.metric.empty() ? "rmse" : options.metric).id;
    bounds.max_error = parse_bound(options.max_error, "greatest error");
    if (!options.max_bits.empty())
        bounds.max_bits = parse_count(options.max_bits, "number of bits per pixel", 1, MAX_BITS);
    if (!options.max_ms.empty()) bounds.max_ms = parse_bound(options.max_ms, "time in milliseconds");
    bounds.order_independent = options.order_independent;
    require_sensible(bounds);
    return bounds;
}

/// The rows of one scene, and what is needed to draw their pictures again.
struct Evidence {
    std::vector<ChartRow> rows;
    glm::ivec2 size{0};
    ParameterValues values;  // of every picture
    Scene scene;
};

// "order=reversed order-seed=1 opacity=0.4", as a chart's settings have it.
ParameterValues values_of(const std::string& text) {
    ParameterValues values;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        const std::string_view setting = std::string_view(text).substr(begin, end - begin);
        const std::size_t equals = setting.find('=');
        const Parameter* row = find_parameter(setting.substr(0, equals));
        if (row == nullptr || equals == std::string_view::npos)
            throw Error(
                fmt::format("The chart has a parameter '{}' that this version does not know; make it "
                            "again.",
                            setting));
        values.set(row->id, parse_parameter(*row, setting.substr(equals + 1)));
        begin = end + 1;
    }
    return values;
}

bool has_parameters(const Options& options) {
    return std::ranges::any_of(options.parameters, [](const auto& one) { return !one.second.empty(); });
}

Evidence read_evidence(const Options& options) {
    if (has_parameters(options))
        throw Error(
            "The rows of a chart have the parameters they were measured with; give none, or leave "
            "--chart out.");
    const Chart chart = chart_of(read_run_table(options.chart), options.chart);
    const std::string shard = setting(chart.settings, run_setting::SHARD);
    if (shard != shard_text({}))
        throw Error(fmt::format("'{}' is the shard {} of a chart; give what momentscope merge makes of all.",
                                options.chart, shard));
    Evidence evidence = {{},
                         parse_size(setting(chart.settings, "size")),
                         values_of(setting(chart.settings, "parameters")),
                         {}};
    const auto scenes = scenes_of(chart);
    const auto found = std::ranges::find_if(scenes, [&](const std::span<const ChartRow> rows) {
        return absolute_scene(rows.front().scene) == absolute_scene(options.scene);
    });
    if (found != scenes.end()) evidence.rows.assign(found->begin(), found->end());
    if (evidence.rows.empty())
        throw Error(fmt::format("'{}' has no rows of the scene '{}', but of {}; chart that scene, too.",
                                options.chart, options.scene, setting(chart.settings, "scenes")));
    Progress progress("Advice");
    evidence.scene = load_scene_option(options, evidence.values, progress);
    const auto place = static_cast<std::size_t>(found - scenes.begin());
    const std::string content = charted_content(chart.settings, place);
    if (!content.empty() && content != scene_content(evidence.scene))
        throw Error(fmt::format("The mesh file '{}' is another one than '{}' was made of; chart it again.",
                                options.scene, options.chart));
    if (options.techniques.empty()) return evidence;
    std::vector<std::string> wanted;
    for (const Configuration& one : charted_configurations(options, evidence.values))
        wanted.push_back(configuration_text(one));
    std::erase_if(evidence.rows, [&](const ChartRow& row) {
        return std::ranges::find(wanted, row.configuration) == wanted.end();
    });
    if (evidence.rows.empty())
        throw Error(fmt::format("'{}' has no rows of these techniques; chart them, too.", options.chart));
    return evidence;
}

Evidence measured_evidence(const Options& options) {
    ChartPlan plan;
    plan.settings = parse_chart_settings(options, "320x180");
    plan.scenes = {options.scene};
    plan.configurations = charted_configurations(options, plan.settings.values);
    Progress progress("Advice");
    Scene scene = load_scene_option(options, plan.settings.values, progress);
    const auto context = make_gl_context("osmesa", {16, 16});
    const ChartHooks hooks = {[&](const std::string&) { return scene; }, [](const RunTable&) {},
                              [&](std::size_t done, std::size_t all) { progress.show(done, all); }};
    const RunTable table = run_chart(plan, {chart_settings(plan, gl_info()), {}, {}}, progress.stop(), hooks);
    progress.require_finished();
    return {chart_of(table, "the chart").rows, plan.settings.size, plan.settings.values, std::move(scene)};
}

Advice checked(const Evidence& evidence, const AdviceBounds& bounds, HeldOutErrors& held_out) {
    Progress progress("Advice at other views");
    const auto context = make_gl_context("osmesa", {16, 16});
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

ui::ExplorerState recipe(const Options& options, const AdviceBounds& bounds,
                         const Configuration& configuration) {
    ui::ExplorerState state;
    state.scene = absolute_scene(options.scene);
    state.technique = configuration.technique;
    state.parameters = configuration.values;
    state.compare.metric = bounds.metric;
    return state;
}

}  // namespace

void run_advise_command(const Options& options) {
    const AdviceBounds bounds = parse_bounds(options);
    ui::require_session_name(options.scene);
    if (!options.output.empty()) {
        if (std::filesystem::path(options.output).extension() != ".json")
            throw Error(fmt::format("A recipe is a .json; '{}' is not.", options.output));
        require_writable(options.output);
    }
    const Evidence evidence = options.chart.empty() ? measured_evidence(options) : read_evidence(options);
    HeldOutErrors held_out(evidence.rows.size());
    const Advice advice = checked(evidence, bounds, held_out);
    if (!advice.winner) throw Error(no_advice_text(evidence.rows, bounds, held_out, advice));
    print(fmt::format("{}, {}x{}: {}, also at views turned by {}\n\n{}", one_line(options.scene),
                      evidence.size.x, evidence.size.y, bounds_text(bounds), HELD_OUT_TEXT,
                      advice_text(evidence.rows, bounds, held_out, advice)));
    const ui::ExplorerState state = recipe(
        options, bounds, parse_configuration(evidence.rows[*advice.winner].configuration, evidence.values));
    if (options.output.empty()) {
        print("\n" + ui::session_text(state));
        return;
    }
    ui::write_session_file(state, options.output);
    print(fmt::format("\nmomentscope explore --session {} opens it.\n", one_line(options.output)));
}

}  // namespace momentscope
