#include "app/ignored_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/error.hpp"

namespace momentscope {

namespace {

/// An option, whether the command would ignore it, and the end of the sentence that says so.
struct Ignored {
    const char* option;
    bool when;
    const char* why;
};

void refuse(const CLI::App& command, std::initializer_list<Ignored> rows) {
    for (const Ignored& row : rows)
        if (row.when && command.get_option(row.option)->count() > 0)
            throw Error(fmt::format("{} changes nothing {}; leave it out.", row.option, row.why));
}

bool ends_in(const std::string& path, const char* extension) {
    return std::filesystem::path(path).extension() == extension;
}

/// What a command reads of the parameters.
struct Reading {
    std::vector<const Technique*> techniques;
    std::vector<ParameterId> others = {};  // that it reads itself
    bool picture = false;                  // shaded colours
    bool order = false;                    // of submission
    bool tone_map = false;
    bool mesh = false;  // is there a mesh file, which has no opacity of its own?
};

template <typename Range>
bool contains(const Range& ids, ParameterId id) {
    return std::ranges::find(ids, id) != ids.end();
}

// An empty text means that the parameter is read.
std::string why_ignored(ParameterId id, const Reading& reading, const ParameterValues& values) {
    if (contains(reading.others, id)) return "";
    if (std::ranges::any_of(reading.techniques, [&](const Technique* t) { return t->uses(id); })) return "";
    if (id == ParameterId::opacity)
        return reading.mesh
                   ? ""
                   : "where there is no mesh file: built-in scenes and rays have their own opacities";
    if (id == ParameterId::tone_map)
        return reading.tone_map ? "" : "here; it is for pictures that end in .png";
    if (id == ParameterId::order && reading.order) return "";
    if (id == ParameterId::order_seed && reading.order)
        return values[ParameterId::order] == 2.0f ? "" : "without --order shuffled";
    if (id == ParameterId::shadows && reading.picture) return "";
    if (contains(SHADOW_PARAMETERS, id) && reading.picture)
        return values[ParameterId::shadows].value_or(0.0f) >= 0.5f ? "" : "without --shadows";
    if (reading.techniques.empty()) return "here";
    if (reading.techniques.size() == 1) return fmt::format("with {}", reading.techniques.front()->id);
    return "with these techniques";
}

void refuse_parameters(const Options& options, const Reading& reading) {
    const ParameterValues values = parse_parameters(options);
    for (const Parameter& row : parameters()) {
        const auto typed = options.parameters.find(row.key);
        if (typed == options.parameters.end() || typed->second.empty()) continue;
        const std::string why = why_ignored(row.id, reading, values);
        if (!why.empty()) throw Error(fmt::format("--{} changes nothing {}; leave it out.", row.key, why));
    }
}

std::vector<const Technique*> techniques_of(const std::vector<Configuration>& configurations) {
    std::vector<const Technique*> techniques;
    for (const Configuration& one : configurations) techniques.push_back(one.technique);
    return techniques;
}

bool any_mesh(const std::string& scenes) {
    const std::vector<std::string> ids = split_list({scenes});
    return scenes != "all" && !std::ranges::all_of(ids, is_builtin_scene);
}

void check_render(const CLI::App& /*command*/, const Options& options) {
    refuse_parameters(options, {.techniques = techniques_of(parse_configurations(options, "power6-32")),
                                .picture = true,
                                .order = true,
                                .tone_map = ends_in(options.output, ".png"),
                                .mesh = any_mesh(options.scene)});
}

void check_inspect(const CLI::App& command, const Options& options) {
    const bool ray = !options.ray.empty();
    refuse(command, {{"--size", ray, "beside --ray, which has no picture"},
                     {"--samples", !options.depths.empty(), "beside --depths"},
                     {"--samples", options.steps, "beside --steps, which are those at --depths"},
                     {"--format", options.steps, "beside --steps, which are text"},
                     {"--light", ray, "beside --ray, which has no scene and no light"},
                     {"--receiver", !options.light, "without --light"}});
    Options lit = options;
    if (options.light) lit.parameters["shadows"] = "1";
    Reading reading = {.techniques = techniques_of(parse_configurations(options, "power6-32")),
                       .picture = !ray,
                       .order = true,
                       .mesh = !ray && any_mesh(options.scene)};
    if (options.light) reading.others = {ParameterId::shadows};
    refuse_parameters(lit, reading);
}

void check_compare(const CLI::App& command, const Options& options) {
    std::vector<const Technique*> drawn;
    for (const std::string& name : options.pictures)
        if (const Technique* technique = find_technique(name.substr(0, name.find(':'))))
            drawn.push_back(technique);
    const char* files = "when both pictures are files";
    refuse(command, {{"--scene", drawn.empty(), files}, {"--size", drawn.empty(), files}});
    refuse_parameters(options, {.techniques = drawn,
                                .picture = !drawn.empty(),
                                .order = !drawn.empty(),
                                .mesh = !drawn.empty() && any_mesh(options.scene)});
}

void check_needed(const CLI::App& /*command*/, const Options& options) {
    refuse_parameters(options, {.techniques = {},
                                .others = {ParameterId::tolerance},
                                .picture = ends_in(options.output, ".png"),
                                .mesh = any_mesh(options.scene)});
}

// The parameters of moments and reconstruction that these techniques read.
std::vector<ParameterId> reconstruction_parameters(const std::vector<const Technique*>& techniques) {
    std::vector<ParameterId> read;
    for (const ParameterId id : {ParameterId::beta, ParameterId::theta, ParameterId::alpha,
                                 ParameterId::preset, ParameterId::solver, ParameterId::tolerance})
        if (std::ranges::any_of(techniques, [&](const Technique* t) { return t->uses(id); }))
            read.push_back(id);
    return read;
}

void check_stress(const CLI::App& /*command*/, const Options& options) {
    const auto techniques =
        options.techniques.empty() ? moment_based_techniques() : parse_techniques(options, "");
    refuse_parameters(options, {.techniques = {}, .others = reconstruction_parameters(techniques)});
}

void check_tune(const CLI::App& command, const Options& options) {
    const bool scene = options.ray.empty() && options.random.empty();
    refuse(command,
           {{"--size", !scene, "without a scene"}, {"--seed", options.random.empty(), "without --random"}});
    refuse_parameters(options, {.techniques = {},
                                .others = reconstruction_parameters(parse_techniques(options, "power8-32")),
                                .order = scene,
                                .mesh = scene && any_mesh(options.scene)});
}

void check_chart(const CLI::App& command, const Options& options) {
    const ParameterValues values = parse_parameters(options);
    if (values[ParameterId::shadows] == 1.0f) {
        const char* shadows = "beside --shadows, whose chart has one error and no shards";
        refuse(command, {{"--metric", true, shadows},
                         {"--shard", true, shadows},
                         {"--technique", true, "beside --shadows; give --shadow-technique"}});
        return refuse_parameters(options,
                                 {.techniques = {}, .picture = true, .mesh = any_mesh(options.scene)});
    }
    refuse(command, {{"--metric", ends_in(options.output, ".csv"), "in a .csv, which has all metrics"}});
    refuse_parameters(options, {.techniques = techniques_of(charted_configurations(options, values)),
                                .picture = true,
                                .order = true,
                                .mesh = any_mesh(options.scene)});
}

void check_advise(const CLI::App& /*command*/, const Options& options) {
    if (!options.chart.empty()) return;  // takes no parameters at all, which it says itself
    refuse_parameters(
        options, {.techniques = techniques_of(charted_configurations(options, parse_parameters(options))),
                  .picture = true,
                  .order = true,
                  .mesh = any_mesh(options.scene)});
}

void check_merge(const CLI::App& command, const Options& options) {
    refuse(command, {{"--metric", ends_in(options.output, ".csv"), "in a .csv, which has all metrics"}});
}

// The window keeps every parameter for the technique and the scene that one chooses there.
void check_explore(const CLI::App& command, const Options& options) {
    refuse(command, {{"--compare", !options.ray.empty(), "beside --ray, which has no picture"}});
}

// `--shadows` alone switches on; `--shadows ''` is a mistake.
void refuse_empty_switches(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options())
        if (option->get_items_expected_min() == 0 &&
            std::ranges::find(option->results(), "") != option->results().end())
            throw Error(
                fmt::format("{} has no value; give on or off, or leave the value out.", option->get_name()));
}

constexpr struct {
    const char* command;
    void (*check)(const CLI::App& command, const Options& options);
} CHECKS[] = {{"explore", check_explore}, {"render", check_render}, {"inspect", check_inspect},
              {"compare", check_compare}, {"needed", check_needed}, {"stress", check_stress},
              {"tune", check_tune},       {"chart", check_chart},   {"advise", check_advise},
              {"merge", check_merge}};

}  // namespace

void refuse_ignored_options(const CLI::App& app, const Options& options) {
    const auto chosen = app.get_subcommands();
    refuse_empty_switches(chosen.empty() ? app : *chosen.front());
    if (chosen.empty()) return check_explore(app, options);
    for (const CLI::Option* option : app.get_options())
        if (option->count() > 0)
            throw Error(fmt::format(
                "{} stands before '{}', where it belongs to the window; write it after the command.",
                option->get_name(), chosen.front()->get_name()));
    for (const auto& row : CHECKS)
        if (chosen.front()->get_name() == row.command) row.check(*chosen.front(), options);
}

void refuse_empty_values(CLI::App& command) {
    for (CLI::Option* option : command.get_options())
        if (option->get_items_expected_max() > 0)
            option->check(
                [](const std::string& value) { return std::string(value.empty() ? "has no value" : ""); });
}

// CLI11 takes "--renormalize=" for "--renormalize".
void refuse_empty_assignments(int argc, const char* const* argv) {
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (word.starts_with("--") && word.ends_with("=") && word.find('=') == word.size() - 1)
            throw Error(fmt::format("'{}' has no value; write one behind it, or leave it out.", word));
    }
}

}  // namespace momentscope
