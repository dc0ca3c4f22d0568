// options.hpp -- options that several commands have. Each add_ function writes into a member of the command,
// when the words are parsed; a text that means no value throws Error then.
#pragma once
#include <CLI/CLI.hpp>
#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/chart/measure.hpp"
#include "core/compare/difference.hpp"
#include "core/scene/scenes.hpp"
#include "core/table/run_table.hpp"
#include "core/techniques/configuration.hpp"

namespace momentscope {

class Progress;

/// An option whose text becomes the value by `parse`.
template <typename T>
CLI::Option* add_parsed(CLI::App& app, const char* name, T& value, const std::string& help,
                        std::function<T(const std::string&)> parse) {
    return app.add_option_function<std::string>(
        name, [&value, parse = std::move(parse)](const std::string& text) { value = parse(text); }, help);
}

constexpr glm::ivec2 PICTURE_SIZE = {960, 540};  // of pictures that are drawn once
constexpr const char* STANDARD_SCENE = "teapots";

CLI::Option* add_scene(CLI::App& app, std::string& id_or_path);

/// "WxH", each from 1 to MAX_PICTURE_SIDE.
CLI::Option* add_size(CLI::App& app, glm::ivec2& size);
glm::ivec2 parse_size(const std::string& text);

/// What was typed as --pixel, X,Y: it is checked against a picture's size once that is known.
struct PixelOption {
    std::string text;
    explicit operator bool() const { return !text.empty(); }
    glm::ivec2 within(glm::ivec2 size) const;
};

/// A whole number from `least` to `most`; `what` names it in the error.
struct CountRange {
    const char* what;
    int least, most;
};
constexpr CountRange RAY_COUNT = {"number of rays", 1, 1'000'000};

/// --help shows the value as the default.
CLI::Option* add_count(CLI::App& app, const char* name, int& value, const std::string& help,
                       const CountRange& range);
int parse_count(const std::string& text, const char* what, int least, int most);

CLI::Option* add_seed(CLI::App& app, std::uint32_t& seed);
CLI::Option* add_rounds(CLI::App& app, int& rounds);
CLI::Option* add_shard(CLI::App& app, Shard& shard);
CLI::Option* add_metric(CLI::App& app, Metric& metric, const char* help);

/// Any finite number; `what` names it in the error.
double parse_bound(const std::string& text, const char* what);

/// The parts between commas of all the values of a repeated option.
std::vector<std::string> split_list(const std::vector<std::string>& values);

/// Parameters that were typed: one option for each row of the registry.
class ParameterOptions {
public:
    void add_to(CLI::App& app);

    /// `values` with those that were typed.
    ParameterValues over(ParameterValues values = {}) const;
    bool has(ParameterId id) const { return typed_.contains(id); }
    bool empty() const { return typed_.empty(); }

private:
    std::map<ParameterId, std::optional<float>> typed_;
};

/// --technique: ids, separated by commas or repeated.
using TechniqueIds = std::vector<std::string>;
CLI::Option* add_techniques(CLI::App& app, TechniqueIds& ids, const std::string& help);

/// Throws Error for an id that does not exist.
std::vector<const Technique*> techniques_of(const TechniqueIds& ids, const char* default_id);

/// The same for configurations such as at:nodes=8, over the parameters that were typed.
std::vector<Configuration> configurations_of(const TechniqueIds& ids, const char* default_id,
                                             const ParameterValues& values);

/// Those of a chart: an id alone stands for its part of the grid. Each once; the whole grid when none were
/// typed.
std::vector<Configuration> charted_configurations(const TechniqueIds& ids, const ParameterValues& values);

/// As load_scene. `progress` shows what is done, and ends it.
Scene load_scene_visibly(const std::string& id_or_path, float opacity, Progress& progress);

/// The same, with the scene's warnings on stderr.
Scene load_scene_and_warn(const std::string& id_or_path, float opacity, Progress& progress);

/// The same with the opacity among parameters.
Scene load_scene_and_warn(const std::string& id_or_path, const ParameterValues& values, Progress& progress);

/// Of --scene: an id, a path, a list of them or "all". The files that the command may read, and whether it
/// reads one.
std::vector<std::string> scene_files(const std::string& text);
bool has_mesh_file(const std::string& text);

}  // namespace momentscope
