// options.hpp -- options that several commands share.
#pragma once
#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

#include "core/chart/measure.hpp"
#include "core/render/view.hpp"
#include "core/scene/scenes.hpp"
#include "core/techniques/configuration.hpp"

namespace momentscope {

class Progress;

/// What was typed, as text; the functions below turn it into values or throw Error.
struct Options {
    std::string scene = "teapots";
    std::string ray;
    std::vector<std::string> techniques;
    std::string pixel;
    std::string size;
    std::string output;
    std::string format;
    std::string depths;
    std::string samples = "512";
    std::vector<std::string> conditions;
    std::string rays = "400";
    std::string seed = "1";
    std::string random;
    std::string max_failures = "0.001";
    std::string reference;  // of the window
    std::string figure;
    std::vector<std::string> pictures;  // of compare: reference and test
    std::string metric;
    std::string region;
    std::string basis = "power";  // of needed
    std::string repeat = "3";
    std::string shard = "1/1";
    std::vector<std::string> files;  // of merge
    std::string max_error;           // of advise
    std::string max_bits;
    std::string max_ms;
    std::string chart;
    bool order_independent = false;
    bool steps = false;
    bool sharp_bounds = false;
    bool light = false;    // of inspect: seen from the light
    std::string receiver;  // "surface" or the number of a fragment
    bool headless = false;
    std::string screenshot;
    std::string session;
    std::string events;
    std::string log;
    std::string ui_scale = "1";
    std::string theme;
    std::map<std::string, std::string> parameters;  // by registry key
};

void add_scene_options(CLI::App& command, Options& options);
void add_parameter_options(CLI::App& command, Options& options);  // one for each row of the registry

constexpr const char* STANDARD_SIZE = "960x540";  // of pictures that are drawn once

/// "WxH", each from 1 to MAX_PICTURE_SIDE.
glm::ivec2 parse_size(const std::string& text);

/// "X,Y" within a picture of that size.
glm::ivec2 parse_pixel(const std::string& text, glm::ivec2 size);

/// From 0.5 to 4.
float parse_scale(const std::string& text);

/// The parts between commas of all the values of a repeated option.
std::vector<std::string> split_list(const std::vector<std::string>& values);

/// "z1,z2,...", each in [-1, 1].
std::vector<float> parse_depths(const std::string& text);

/// A rate from 0 to 1.
double parse_rate(const std::string& text);

/// A whole number from `least` to `most`; `what` names it in the error.
int parse_count(const std::string& text, const char* what, int least, int most);

/// How many random rays, and the seed of the first.
int parse_ray_count(const std::string& text);
std::uint32_t parse_seed(const std::string& text);

/// Any finite number; `what` names it in the error.
double parse_bound(const std::string& text, const char* what);

/// The parameters that were typed, over `standard`.
ParameterValues parse_parameters(const Options& options, ParameterValues default_value = {});
std::vector<const Technique*> parse_techniques(const Options& options, const char* default_value);

/// Ids of techniques, or configurations such as at:nodes=8, over the parameters that were typed.
std::vector<Configuration> parse_configurations(const Options& options, const char* default_value);

/// Size, rounds and the pictures' parameters; `standard_size` as "WxH".
ChartSettings parse_chart_settings(const Options& options, const char* standard_size);

/// Those of a chart: an id alone stands for its part of the grid. Each once; the whole grid when none were
/// typed.
std::vector<Configuration> charted_configurations(const Options& options, const ParameterValues& values);

/// As load_scene. `progress` shows what is done, and ends it.
Scene load_scene_visibly(const std::string& id_or_path, float opacity, Progress& progress);

/// The same, with the scene's warnings on stderr.
Scene load_scene_and_warn(const std::string& id_or_path, float opacity, Progress& progress);

/// The same with the scene and the opacity that are asked for.
Scene load_scene_option(const Options& options, const ParameterValues& parameters, Progress& progress);

}  // namespace momentscope
