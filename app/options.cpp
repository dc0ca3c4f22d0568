#include "app/options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/gl_context.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "core/chart/grid.hpp"
#include "core/render/view.hpp"
#include "core/support/error.hpp"
#include "core/support/parse_number.hpp"

namespace momentscope {

namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0;;) {
        const std::size_t end = text.find(separator, begin);
        parts.push_back(text.substr(begin, end - begin));
        if (end == std::string_view::npos) return parts;
        begin = end + 1;
    }
}

}  // namespace

CLI::Option* add_scene(CLI::App& app, std::string& id_or_path) {
    return app.add_option("--scene", id_or_path, "id of a scene, or the path of a mesh file")
        ->capture_default_str();
}

CLI::Option* add_gl(CLI::App& app, const char* otherwise) {
    std::string help;
    for (const HeadlessGl& row : headless_gls())
        if (row.built) help += fmt::format("{}{} ({})", help.empty() ? "" : ", ", row.key, row.help);
    return app.add_option_function<std::string>(
        "--gl", choose_headless_gl,
        fmt::format("what draws without a window: {} [MOMENTSCOPE_GL of the environment, or {}]", help,
                    otherwise));
}

CLI::Option* add_size(CLI::App& app, glm::ivec2& size) {
    return add_parsed<glm::ivec2>(app, "--size", size, "width and height in pixels", parse_size)
        ->default_str(fmt::format("{}x{}", size.x, size.y));
}

glm::ivec2 parse_size(const std::string& text) {
    const auto parts = split(text, 'x');
    const auto width = parts.size() == 2 ? parse_number<int>(parts[0]) : std::nullopt;
    const auto height = parts.size() == 2 ? parse_number<int>(parts[1]) : std::nullopt;
    if (!width || !height || std::min(*width, *height) < 1 || std::max(*width, *height) > MAX_PICTURE_SIDE)
        throw Error(
            fmt::format("The size '{}' is not a WIDTHxHEIGHT from 1x1 to {}x{}; give one such as 960x540.",
                        text, MAX_PICTURE_SIDE, MAX_PICTURE_SIDE));
    return {*width, *height};
}

glm::ivec2 PixelOption::within(glm::ivec2 size) const {
    const auto parts = split(text, ',');
    const auto x = parts.size() == 2 ? parse_number<int>(parts[0]) : std::nullopt;
    const auto y = parts.size() == 2 ? parse_number<int>(parts[1]) : std::nullopt;
    if (!x || !y || *x < 0 || *y < 0 || *x >= size.x || *y >= size.y)
        throw Error(
            fmt::format("The pixel '{}' is not an X,Y from 0,0 to {},{}; give one within the picture.", text,
                        size.x - 1, size.y - 1));
    return {*x, *y};
}

CLI::Option* add_count(CLI::App& app, const char* name, int& value, const std::string& help,
                       const CountRange& range) {
    return add_parsed<int>(app, name, value, help,
                           [range](const std::string& text) {
                               return parse_count(text, range.what, range.least, range.most);
                           })
        ->default_str(std::to_string(value));
}

int parse_count(const std::string& text, const char* what, int least, int most) {
    const auto count = parse_number<int>(text);
    if (!count || *count < least || *count > most)
        throw Error(
            fmt::format("'{}' is not a {}; give a whole number from {} to {}.", text, what, least, most));
    return *count;
}

CLI::Option* add_seed(CLI::App& app, std::uint32_t& seed) {
    return add_parsed<std::uint32_t>(
               app, "--seed", seed, "seed of the random rays",
               [](const std::string& text) {
                   return static_cast<std::uint32_t>(parse_count(text, "seed", 0, 2'000'000'000));
               })
        ->default_str(std::to_string(seed));
}

CLI::Option* add_rounds(CLI::App& app, int& rounds) {
    constexpr int MAX_ROUNDS = 1000;
    return add_count(app, "--repeat", rounds, "number of rounds; each configuration is timed once per round",
                     {"number of rounds", 1, MAX_ROUNDS});
}

CLI::Option* add_shard(CLI::App& app, Shard& shard) {
    return add_parsed<Shard>(
               app, "--shard", shard,
               "measure only a part of the rows, such as 2/4 for the second of four (see merge)", parse_shard)
        ->default_str(shard_text(shard));
}

CLI::Option* add_metric(CLI::App& app, Metric& metric, const char* help) {
    return add_parsed<Metric>(app, "--metric", metric, help,
                              [](const std::string& key) { return require_metric(key).id; });
}

double parse_bound(const std::string& text, const char* what) {
    const auto value = parse_number<double>(text);
    if (!value) throw Error(fmt::format("'{}' is not a {}; give a number above 0.", text, what));
    return *value;
}

std::vector<std::string> split_list(const std::vector<std::string>& values) {
    std::vector<std::string> parts;
    for (const std::string& list : values)
        for (const std::string_view part : split(list, ',')) parts.emplace_back(part);
    return parts;
}

void ParameterOptions::add_to(CLI::App& app) {
    for (const Parameter& row : parameters()) {
        CLI::Option* option = app.add_option_function<std::string>(
            fmt::format("--{}", row.key),
            [this, &row](const std::string& text) { typed_[row.id] = parse_parameter(row, text); },
            fmt::format("{} {}: {} [{}]", row.name, row.symbol, parameter_values_text(row),
                        parameter_text(row, row.default_value)));
        if (row.scale == Scale::toggle) option->expected(0, 1)->default_str("on")->type_name("[on|off]");
    }
}

ParameterValues ParameterOptions::over(ParameterValues values) const {
    for (const auto& [id, value] : typed_) values.set(id, value);
    return values;
}

CLI::Option* add_techniques(CLI::App& app, TechniqueIds& ids, const std::string& help) {
    return app.add_option("--technique", ids, help);
}

std::vector<const Technique*> techniques_of(const TechniqueIds& ids, const char* default_id) {
    std::vector<const Technique*> techniques;
    for (const std::string& id : split_list(ids)) techniques.push_back(&require_technique(id));
    if (techniques.empty()) techniques.push_back(&require_technique(default_id));
    return techniques;
}

std::vector<Configuration> configurations_of(const TechniqueIds& ids, const char* default_id,
                                             const ParameterValues& values) {
    std::vector<Configuration> configurations;
    for (const std::string& list : ids)
        for (const std::string& text : split_configurations(list))
            configurations.push_back(parse_configuration(text, values));
    if (configurations.empty()) configurations.push_back(parse_configuration(default_id, values));
    return configurations;
}

std::vector<Configuration> charted_configurations(const TechniqueIds& ids, const ParameterValues& values) {
    if (ids.empty()) return chart_grid(values);
    std::vector<Configuration> all;
    std::set<std::string> texts;
    for (const std::string& list : ids)
        for (const std::string& text : split_configurations(list)) {
            const Configuration one = parse_configuration(text, values);
            const auto chosen = text.find(':') == std::string::npos ? chart_grid(*one.technique, values)
                                                                    : std::vector<Configuration>{one};
            for (const Configuration& configuration : chosen)
                if (texts.insert(configuration_text(configuration)).second) all.push_back(configuration);
        }
    return all;
}

Scene load_scene_visibly(const std::string& id_or_path, float opacity, Progress& progress) {
    Scene scene;
    try {
        scene = load_scene(id_or_path, opacity, progress.stop(), [&](const std::string& what) {
            progress.show_stage(std::filesystem::path(id_or_path).filename().string() + ": " + what);
        });
    } catch (const Error&) {
        progress.require_finished();  // reports the stop if the user stopped it
        throw;
    }
    progress.show_stage("");
    return scene;
}

Scene load_scene_and_warn(const std::string& id_or_path, float opacity, Progress& progress) {
    Scene scene = load_scene_visibly(id_or_path, opacity, progress);
    for (const std::string& warning : scene.warnings) warn(warning);
    return scene;
}

Scene load_scene_and_warn(const std::string& id_or_path, const ParameterValues& values, Progress& progress) {
    return load_scene_and_warn(id_or_path, values.number(ParameterId::opacity), progress);
}

std::vector<std::string> scene_files(const std::string& text) {
    if (text == "all" || is_builtin_scene(text)) return {};
    std::vector<std::string> files = {text};  // the name of a file may contain commas
    for (const std::string& scene : split_list({text}))
        if (!is_builtin_scene(scene)) files.push_back(scene);
    return files;
}

bool has_mesh_file(const std::string& text) {
    return text != "all" && !std::ranges::all_of(split_list({text}), is_builtin_scene);
}

}  // namespace momentscope
