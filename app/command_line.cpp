#include "app/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <new>
#include <sstream>
#include <system_error>

#include "app/commands.hpp"
#include "app/end_by_signal.hpp"
#include "app/ignored_options.hpp"
#include "app/output_conflicts.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "core/error.hpp"

namespace momentscope {

namespace {

constexpr const char* ABOUT = "Momentscope: an oscilloscope for moment-based order-independent transparency.";

// A ray stands in for a pixel of a scene.
void add_ray_option(CLI::App& command, Options& options) {
    CLI::Option* ray =
        command.add_option("--ray", options.ray, "JSON file of a view ray, instead of a pixel of a scene");
    ray->excludes(command.get_option("--scene"), command.get_option("--pixel"));
}

void add_explore_options(CLI::App& command, Options& options) {
    add_scene_options(command, options);
    command.add_option("--pixel", options.pixel, "picked pixel of the scene's picture, as 320,200");
    add_ray_option(command, options);
    command.add_option(
        "--technique", options.techniques,
        "ids of techniques (momentscope list techniques); those after the first are only plotted");
    command.add_option("--compare", options.reference,
                       "id of the technique that the picture is compared with [sorted]");
    command.add_option("--session", options.session, "JSON file that the window saved, to go on from there")
        ->excludes(command.get_option("--scene"), command.get_option("--ray"),
                   command.get_option("--technique"));
    command.add_flag("--headless", options.headless, "draw without a display");
    command.add_option("--screenshot", options.screenshot,
                       "with --headless: where to write the window as .png");
    command.add_option("--events", options.events,
                       "with --headless: file of mouse and keyboard events to replay");
    command.add_option("--log", options.log, "where to write which frames were drawn and what they computed");
    command.add_option("--ui-scale", options.ui_scale, "size of the window's text, 0.5 to 4")
        ->capture_default_str();
    command.add_option("--theme", options.theme, "dark or light [dark]");
    add_parameter_options(command, options);
}

void add_inspect(CLI::App& app, Options& options) {
    CLI::App* inspect = app.add_subcommand("inspect", "print the functions behind a pixel or along a ray");
    add_scene_options(*inspect, options);
    inspect->add_option("--pixel", options.pixel,
                        "pixel of the picture, as 320,200; the scene's own if left out");
    add_ray_option(*inspect, options);
    inspect->add_option(
        "--technique", options.techniques,
        "ids of techniques or configurations such as at:nodes=8, separated by commas or repeated");
    inspect->add_option("--samples", options.samples, "how many depths from -1 to 1")->capture_default_str();
    inspect->add_option("--depths", options.depths, "depths instead of --samples, as -0.5,0,0.25");
    inspect->add_flag("--steps", options.steps,
                      "print the steps of the reconstruction at --depths [0] instead of curves");
    inspect->add_flag("--sharp-bounds", options.sharp_bounds,
                      "add the least and greatest absorbance that the moments leave possible");
    inspect->add_flag("--light", options.light,
                      "the function that the light's map has of what the pixel shows, instead of the eye's");
    inspect->add_option(
        "--receiver", options.receiver,
        "of --light: the number of a fragment from 1, the nearest, or surface, the opaque one "
        "[what is seen of the pixel]");
    inspect->add_option("--format", options.format, "json, csv or table [json]");
    inspect->add_option("-o,--output", options.output, "file to write instead of standard output");
    add_parameter_options(*inspect, options);
}

void add_shard_option(CLI::App& command, Options& options) {
    command
        .add_option("--shard", options.shard, "a part of the rows, as 2/4 for the second of four (see merge)")
        ->capture_default_str();
}

void add_stress(CLI::App& app, Options& options) {
    CLI::App* stress =
        app.add_subcommand("stress", "try techniques under hard conditions and count failures");
    stress->add_option("--technique", options.techniques, "ids of techniques with moments [all]");
    stress->add_option("--condition", options.conditions,
                       "ids of conditions (momentscope list conditions) [all]");
    stress->add_option("--rays", options.rays, "random rays for each technique and condition")
        ->capture_default_str();
    stress->add_option("--seed", options.seed, "of the random rays")->capture_default_str();
    add_shard_option(*stress, options);
    stress->add_option("-o,--output", options.output, ".csv, .html or .png (a heat map)");
    add_parameter_options(*stress, options);
}

void add_tune(CLI::App& app, Options& options) {
    CLI::App* tune = app.add_subcommand("tune", "find the moment bias, θ and β of least error");
    add_scene_options(*tune, options);
    CLI::Option* ray = tune->add_option("--ray", options.ray, "JSON file of a view ray, instead of a scene");
    CLI::Option* random = tune->add_option("--random", options.random,
                                           "how many random rays of 2 to 5 fragments, instead of a scene");
    ray->excludes(tune->get_option("--scene"), random);
    random->excludes(tune->get_option("--scene"));
    tune->add_option("--technique", options.techniques, "id of a technique with moments [power8-32]");
    tune->add_option("--max-failures", options.max_failures, "highest failure rate of a safe bias")
        ->capture_default_str();
    tune->add_option("--seed", options.seed, "of the random rays")->capture_default_str();
    add_parameter_options(*tune, options);
}

void add_compare(CLI::App& app, Options& options) {
    CLI::App* compare = app.add_subcommand("compare", "tell how far a picture is from a reference");
    compare
        ->add_option(
            "pictures", options.pictures,
            "reference and test: picture files, or techniques that draw the scene, as at or at:nodes=8")
        ->required()
        ->expected(2);
    add_scene_options(*compare, options);
    compare->add_option("--metric", options.metric, "rmse, delta-e or flip; all if left out");
    compare->add_option("--region", options.region, "x,y,width,height to average over, instead of all");
    compare->add_option("-o,--output", options.output, "where to write a map of the metric as .png");
    add_parameter_options(*compare, options);
}

void add_needed(CLI::App& app, Options& options) {
    CLI::App* needed = app.add_subcommand(
        "needed", "tell how many moments the pixels of a scene need, by bounds and by error");
    add_scene_options(*needed, options);
    needed->add_option("--basis", options.basis, "power or chebyshev")->capture_default_str();
    needed->add_option("--format", options.format, "table or json [table]");
    needed->add_option("-o,--output", options.output, ".png (maps) or .json");
    add_parameter_options(*needed, options);
}

void add_figure(CLI::App& app, Options& options) {
    CLI::App* figure =
        app.add_subcommand("figure", "redo a figure of the papers, and measure what they say of it");
    figure->add_option("figure", options.figure, "id of a figure (momentscope list figures), or all")
        ->required();
    figure->add_option("-o,--output", options.output, "folder for the pictures [figures]");
}

void add_metric_option(CLI::App& command, Options& options) {
    command.add_option("--metric", options.metric, "error of drawings: rmse, delta-e or flip [rmse]");
}

void add_chart(CLI::App& app, Options& options) {
    CLI::App* chart = app.add_subcommand("chart", "chart the speed of techniques against their accuracy");
    chart
        ->add_option("--scene", options.scene,
                     "ids of scenes or paths of mesh files, separated by commas, or all")
        ->capture_default_str();
    chart->add_option("--size", options.size, "width and height in pixels [640x360]");
    chart->add_option("--technique", options.techniques,
                      "ids of techniques, or single configurations such as at:nodes=8 [all]");
    chart->add_option("--repeat", options.repeat, "rounds in which each configuration is timed once")
        ->capture_default_str();
    add_metric_option(*chart, options);
    add_shard_option(*chart, options);
    chart->footer(
        "With --shadows: what shadows of transparent casters cost, in .csv or .md, for --shadow-technique [fourier-7, "
        "fourier-15, power4-32 and power6-32] and --shadow-size [1024 and 2048].");
    chart->add_option("-o,--output", options.output,
                      ".csv, .md, .svg, .html or .png; the same command goes on where an ended one stopped");
    add_parameter_options(*chart, options);
}

void add_advise(CLI::App& app, Options& options) {
    CLI::App* advise = app.add_subcommand("advise", "find the cheapest technique that meets bounds");
    advise->add_option("--scene", options.scene, "id of a scene, or the path of a mesh file")
        ->capture_default_str();
    advise->add_option("--max-error", options.max_error, "greatest error against sorted")->required();
    advise->add_option("--metric", options.metric, "of the error: rmse, delta-e or flip [rmse]");
    advise->add_option("--max-bits", options.max_bits, "most bits per pixel beside the colour buffers");
    advise->add_option("--max-ms", options.max_ms, "longest time of a technique's passes in milliseconds");
    advise->add_flag("--order-independent", options.order_independent,
                     "leave out what depends on the order of submission");
    CLI::Option* size = advise->add_option("--size", options.size, "width and height in pixels [320x180]");
    advise->add_option("--technique", options.techniques,
                       "ids of techniques, or single configurations such as at:nodes=8 [all]");
    CLI::Option* repeat =
        advise->add_option("--repeat", options.repeat, "rounds in which each configuration is timed once")
            ->capture_default_str();
    advise->add_option("--chart", options.chart, "rows of a .csv of momentscope chart instead of new ones")
        ->excludes(size, repeat);
    advise->add_option("-o,--output", options.output,
                       "where to write the recipe as .json, which --session of the window opens");
    add_parameter_options(*advise, options);
}

void add_merge(CLI::App& app, Options& options) {
    CLI::App* merge = app.add_subcommand("merge", "put the shards of a chart or stress run together");
    merge->add_option("files", options.files, "the .csv files of all shards of one run")->required();
    add_metric_option(*merge, options);
    merge->add_option("-o,--output", options.output, ".csv, or of a chart .md, .svg, .html or .png")
        ->required();
}

void add_commands(CLI::App& app, Options& options, std::string& what) {
    add_explore_options(app, options);
    CLI::App* explore = app.add_subcommand("explore", "open the window (the default)");
    add_explore_options(*explore, options);

    CLI::App* render = app.add_subcommand("render", "draw a scene to a picture");
    add_scene_options(*render, options);
    render->add_option("--technique", options.techniques,
                       "id of a technique, or a configuration such as at:nodes=8");
    render->add_option("-o,--output", options.output, ".exr (linear floats) or .png")->required();
    add_parameter_options(*render, options);

    add_inspect(app, options);
    add_compare(app, options);
    add_figure(app, options);
    add_needed(app, options);
    add_stress(app, options);
    add_tune(app, options);
    add_chart(app, options);
    add_advise(app, options);
    add_merge(app, options);

    CLI::App* list = app.add_subcommand("list", "print a registry");
    list->add_option("what", what,
                     "techniques, scenes, parameters, conditions, figures or commands (of the window)")
        ->required();
    list->add_option("--format", options.format, "table, json or markdown [table]");
    app.require_subcommand(0, 1);
    refuse_empty_values(app);
    for (CLI::App* command : app.get_subcommands(nullptr)) refuse_empty_values(*command);
}

void run(const CLI::App& app, const Options& options, const std::string& what) {
    if (app.got_subcommand("render")) return run_render(options);
    if (app.got_subcommand("inspect")) return run_inspect(options);
    if (app.got_subcommand("compare")) return run_compare(options);
    if (app.got_subcommand("needed")) return run_needed(options);
    if (app.got_subcommand("figure")) return run_figure(options);
    if (app.got_subcommand("stress")) return run_stress_command(options);
    if (app.got_subcommand("tune")) return run_tune_command(options);
    if (app.got_subcommand("chart")) return run_chart_command(options);
    if (app.got_subcommand("advise")) return run_advise_command(options);
    if (app.got_subcommand("merge")) return run_merge_command(options);
    if (app.got_subcommand("list")) return run_list(what, options.format.empty() ? "table" : options.format);
    run_explore(options);
}

int fail(const std::string& sentence) {
    warn(sentence);
    return 1;
}

void parse_and_run(int argc, const char* const* argv) {
    refuse_empty_assignments(argc, argv);
    CLI::App app(ABOUT, "momentscope");
    Options options;
    std::string what;
    add_commands(app, options, what);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help) {
        std::ostringstream text;
        app.exit(help, text, text);
        print(text.str());
        return require_printed();
    } catch (const CLI::ParseError& error) {
        throw Error(fmt::format("{}; momentscope --help lists what there is.", error.what()));
    }
    refuse_ignored_options(app, options);
    refuse_outputs_that_are_inputs(options);
    run(app, options, what);
    require_printed();
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
    occupy_closed_streams();
    end_cleanly_on_signals();
    std::signal(SIGXFSZ, SIG_IGN);  // writing beyond the largest file allowed fails like on a full disk
    try {
        parse_and_run(argc, argv);
        return 0;
    } catch (const Interrupted& end) {
        fail(end.what());
        std::fflush(stdout);
        end_by_signal(end.signal);
    } catch (const Error& error) {
        return fail(error.what());
    } catch (const std::bad_alloc&) {
        return fail("Memory ran out; try a smaller --size or a smaller scene.");
    } catch (const std::system_error& error) {  // a thread, for instance
        return fail(fmt::format(
            "The system refuses what the program needs ({}); close other programs, or check limits.",
            error.code().message()));
    } catch (const std::exception& error) {  // what nobody thought of must not end in a stack trace
        return fail(fmt::format("Something failed that should not: {}; please report it.", error.what()));
    }
}

}  // namespace momentscope
