// options.hpp -- options that several commands share. Each add_ function adds an option that writes to a
// member of the command when the words are parsed. Parsing throws Error for an invalid text.
#pragma once
#include <CLI/CLI.hpp>
#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/bench/measure.hpp"
#include "core/compare/difference.hpp"
#include "core/scene/scenes.hpp"
#include "core/table/run_table.hpp"
#include "core/techniques/configuration.hpp"

namespace momentscope {

class Progress;

/// An option whose text is converted to the value by `parse`.
template <typename T>
CLI::Option* add_parsed(CLI::App& app, const char* name, T& value, const std::string& help,
                        std::function<T(const std::string&)> parse) {
    return app.add_option_function<std::string>(
        name, [&value, parse = std::move(parse)](const std::string& text) { value = parse(text); }, help);
}

constexpr glm::ivec2 PICTURE_SIZE = {960, 540};  // size of single pictures
constexpr const char* STANDARD_SCENE = "teapots";

CLI::Option* add_scene(CLI::App& app, std::string& id_or_path);

/// "WxH", each from 1 to MAX_PICTURE_SIDE.
CLI::Option* add_size(CLI::App& app, glm::ivec2& size);
glm::ivec2 parse_size(const std::string& text);

/// The typed text of --pixel, X,Y. within() checks it against the size of a picture.
struct PixelOption {
    std::string text;
    explicit operator bool() const { return !text.empty(); }
    glm::ivec2 within(glm::ivec2 size) const;
};

/// Limits of a whole number; `what` names it in the error.
struct CountRange {
    const char* what;
    int least, most;
};
constexpr CountRange RAY_COUNT = {"number of rays", 1, 1'000'000};

/// Adds an option for a whole number. --help shows the current value as the default.
CLI::Option* add_count(CLI::App& app, const char* name, int& value, const std::string& help,
                       const CountRange& range);
int parse_count(const std::string& text, const char* what, int least, int most);

/// "--gl": the kind of OpenGL that draws without a window.
CLI::Option* add_gl(CLI::App& app, const char* otherwise = "osmesa");

CLI::Option* add_seed(CLI::App& app, std::uint32_t& seed);
CLI::Option* add_rounds(CLI::App& app, int& rounds);
CLI::Option* add_shard(CLI::App& app, Shard& shard);
CLI::Option* add_metric(CLI::App& app, Metric& metric, const char* help);

/// Accepts any finite number; `what` names it in the error.
double parse_bound(const std::string& text, const char* what);

/// The comma-separated parts of all values of a repeated option.
std::vector<std::string> split_list(const std::vector<std::string>& values);

/// The typed parameters, with one option for each row of the registry.
class ParameterOptions {
public:
    void add_to(CLI::App& app);

    /// `values`, overridden by the typed parameters.
    ParameterValues over(ParameterValues values = {}) const;
    bool has(ParameterId id) const { return typed_.contains(id); }
    bool empty() const { return typed_.empty(); }

private:
    std::map<ParameterId, std::optional<float>> typed_;
};

/// The values of --technique: ids, separated by commas or in repeated options.
using TechniqueIds = std::vector<std::string>;
CLI::Option* add_techniques(CLI::App& app, TechniqueIds& ids, const std::string& help);

/// Throws Error if an id does not exist.
std::vector<const Technique*> techniques_of(const TechniqueIds& ids, const char* default_id);

/// The same for configurations such as at:nodes=8. Typed parameters are their base.
std::vector<Configuration> configurations_of(const TechniqueIds& ids, const char* default_id,
                                             const ParameterValues& values);

/// The configurations of a chart, each once. An id without parameters stands for its part of the grid; the
/// whole grid is taken if none were typed.
std::vector<Configuration> charted_configurations(const TechniqueIds& ids, const ParameterValues& values);

/// Like load_scene, but `progress` shows the current step and can stop the loading.
Scene load_scene_visibly(const std::string& id_or_path, float opacity, Progress& progress);

/// The same, but it also prints the scene's warnings on stderr.
Scene load_scene_and_warn(const std::string& id_or_path, float opacity, Progress& progress);

/// The same, with the opacity from the parameters.
Scene load_scene_and_warn(const std::string& id_or_path, const ParameterValues& values, Progress& progress);

/// For the text of --scene, which is an id, a path, a list of them or "all": the files that the command may
/// read, and whether it reads any.
std::vector<std::string> scene_files(const std::string& text);
bool has_mesh_file(const std::string& text);

}  // namespace momentscope
