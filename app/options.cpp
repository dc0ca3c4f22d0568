#include "app/options.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "core/chart/grid.hpp"
#include "core/error.hpp"
#include "core/parse_number.hpp"

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

void add_scene_options(CLI::App& command, Options& options) {
    command.add_option("--scene", options.scene, "id of a scene, or the path of a mesh file")
        ->capture_default_str();
    command.add_option("--size", options.size, "width and height in pixels, as 960x540");
}

void add_parameter_options(CLI::App& command, Options& options) {
    for (const Parameter& row : parameters()) {
        CLI::Option* option =
            command.add_option(fmt::format("--{}", row.key), options.parameters[row.key],
                               fmt::format("{} {}: {} [{}]", row.name, row.symbol, parameter_values_text(row),
                                           parameter_text(row, row.default_value)));
        if (row.scale == Scale::toggle) option->expected(0, 1)->default_str("on")->type_name("[on|off]");
    }
}

glm::ivec2 parse_size(const std::string& text) {
    const auto parts = split(text, 'x');
    const auto width = parts.size() == 2 ? parse_number<int>(parts[0]) : std::nullopt;
    const auto height = parts.size() == 2 ? parse_number<int>(parts[1]) : std::nullopt;
    if (!width || !height || std::min(*width, *height) < 1 || std::max(*width, *height) > MAX_PICTURE_SIDE)
        throw Error(
            fmt::format("The size '{}' is no WIDTHxHEIGHT from 1x1 to {}x{}; give one such as 960x540.", text,
                        MAX_PICTURE_SIDE, MAX_PICTURE_SIDE));
    return {*width, *height};
}

glm::ivec2 parse_pixel(const std::string& text, glm::ivec2 size) {
    const auto parts = split(text, ',');
    const auto x = parts.size() == 2 ? parse_number<int>(parts[0]) : std::nullopt;
    const auto y = parts.size() == 2 ? parse_number<int>(parts[1]) : std::nullopt;
    if (!x || !y || *x < 0 || *y < 0 || *x >= size.x || *y >= size.y)
        throw Error(fmt::format("The pixel '{}' is no X,Y from 0,0 to {},{}; give one within the picture.",
                                text, size.x - 1, size.y - 1));
    return {*x, *y};
}

float parse_scale(const std::string& text) {
    const auto scale = parse_number<float>(text);
    if (!scale || !(*scale >= 0.5f && *scale <= 4))
        throw Error(
            fmt::format("'{}' is not a scale of the window's text; give --ui-scale from 0.5 to 4.", text));
    return *scale;
}

std::vector<float> parse_depths(const std::string& text) {
    std::vector<float> depths;
    for (const std::string_view part : split(text, ',')) {
        const auto depth = parse_number<float>(part);
        if (!depth || !(*depth >= -1 && *depth <= 1))
            throw Error(fmt::format(
                "The depth '{}' is not a number from -1 to 1; give --depths as -0.5,0,0.25.", part));
        depths.push_back(*depth);
    }
    return depths;
}

int parse_count(const std::string& text, const char* what, int least, int most) {
    const auto count = parse_number<int>(text);
    if (!count || *count < least || *count > most)
        throw Error(
            fmt::format("'{}' is no {}; give a whole number from {} to {}.", text, what, least, most));
    return *count;
}

int parse_ray_count(const std::string& text) {
    return parse_count(text, "number of rays", 1, 1'000'000);
}

std::uint32_t parse_seed(const std::string& text) {
    return static_cast<std::uint32_t>(parse_count(text, "seed", 0, 2'000'000'000));
}

double parse_bound(const std::string& text, const char* what) {
    const auto value = parse_number<double>(text);
    if (!value) throw Error(fmt::format("'{}' is no {}; give a number above 0.", text, what));
    return *value;
}

ParameterValues parse_parameters(const Options& options, ParameterValues values) {
    for (const auto& [key, text] : options.parameters) {
        if (text.empty()) continue;
        const Parameter& row = *find_parameter(key);
        values.set(row.id, parse_parameter(row, text));
    }
    return values;
}

double parse_rate(const std::string& text) {
    const auto rate = parse_number<double>(text);
    if (!rate || !(*rate >= 0 && *rate <= 1))
        throw Error(fmt::format("'{}' is not a rate; give a number from 0 to 1, such as 0.0001.", text));
    return *rate;
}

std::vector<std::string> split_list(const std::vector<std::string>& values) {
    std::vector<std::string> parts;
    for (const std::string& list : values)
        for (const std::string_view part : split(list, ',')) parts.emplace_back(part);
    return parts;
}

std::vector<const Technique*> parse_techniques(const Options& options, const char* default_value) {
    std::vector<const Technique*> techniques;
    for (const std::string& id : split_list(options.techniques)) techniques.push_back(&require_technique(id));
    if (techniques.empty()) techniques.push_back(&require_technique(default_value));
    return techniques;
}

std::vector<Configuration> parse_configurations(const Options& options, const char* default_value) {
    const ParameterValues values = parse_parameters(options);
    std::vector<Configuration> configurations;
    for (const std::string& list : options.techniques)
        for (const std::string& text : split_configurations(list))
            configurations.push_back(parse_configuration(text, values));
    if (configurations.empty()) configurations.push_back(parse_configuration(default_value, values));
    return configurations;
}

ChartSettings parse_chart_settings(const Options& options, const char* standard_size) {
    constexpr int MAX_ROUNDS = 1000;
    return {parse_size(options.size.empty() ? standard_size : options.size),
            parse_count(options.repeat, "number of rounds", 1, MAX_ROUNDS), parse_parameters(options)};
}

std::vector<Configuration> charted_configurations(const Options& options, const ParameterValues& values) {
    if (options.techniques.empty()) return chart_grid(values);
    std::vector<Configuration> all;
    std::set<std::string> texts;
    for (const std::string& list : options.techniques)
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
        progress.require_finished();  // or it was ended
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

Scene load_scene_option(const Options& options, const ParameterValues& parameters, Progress& progress) {
    return load_scene_and_warn(options.scene, *parameters[ParameterId::opacity], progress);
}

}  // namespace momentscope
