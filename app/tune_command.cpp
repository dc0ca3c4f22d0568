#include <fmt/format.h>

#include <algorithm>

#include "app/command.hpp"
#include "app/gl_context.hpp"
#include "app/ignored_options.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "core/ray/ray_json.hpp"
#include "core/render/renderer.hpp"
#include "core/stress/tune.hpp"
#include "core/support/error.hpp"
#include "core/support/parse_number.hpp"
#include "core/techniques/moment_kernel.hpp"

namespace momentscope {

namespace {

constexpr int OVERDRAW_RAYS = 300;

double parse_rate(const std::string& text) {
    const auto rate = parse_number<double>(text);
    if (!rate || !(*rate >= 0 && *rate <= 1))
        throw Error(fmt::format("'{}' is not a rate; give a number from 0 to 1, such as 0.0001.", text));
    return *rate;
}

std::string percent(double rate) {
    return rate > 0 ? fmt::format("{:.2g} %", 100 * rate) : "0 %";
}

const char* preset_name(const Technique& technique, const Trial& trial) {
    if (trial.parameter != ParameterId::alpha) return "";
    if (trial.value == technique.moments().recommended_bias) return "  (Table 1)";
    return trial.value == technique.moments().robust_bias ? "  (preset robust)" : "";
}

bool was_tuned(const TuneResult& result, ParameterId id) {
    return std::ranges::find(result.trials, id, &Trial::parameter) != result.trials.end();
}

// One table per parameter. Failures of exact arithmetic on the stored moments cannot be avoided by any
// solver.
void print_trials(const Technique& technique, const TuneResult& result) {
    for (const ParameterId id : {ParameterId::alpha, ParameterId::theta, ParameterId::beta}) {
        if (!was_tuned(result, id)) continue;
        const Parameter& row = parameter(id);
        const bool judged = id == ParameterId::alpha;
        print(fmt::format("\n{} --{}{}\n{:>12}  rms error of T{}\n", row.name, row.key,
                          judged && was_tuned(result, ParameterId::beta) ? " (at beta = 0)" : "", "value",
                          judged ? "  failures  of exact arithmetic on the stored moments" : ""));
        for (const Trial& trial : result.trials) {
            if (trial.parameter != id) continue;
            const std::string failures = judged ? fmt::format("  {:<8}  {:<8}", percent(trial.failure_rate),
                                                              percent(trial.inherent_rate))
                                                : "";
            print(fmt::format("{:>12.3g}  {:<14.4g}{}{}{}\n", trial.value, trial.error, failures,
                              preset_name(technique, trial),
                              trial.value == result.values[id] ? "  <- chosen" : ""));
        }
    }
}

void print_result(const Technique& technique, const TuneResult& result) {
    if (!result.safe)
        print(fmt::format(
            "\nNo moment bias keeps the failure rate below the limit; this one fails least ({}).\n",
            percent(result.failure_rate)));
    std::string options;
    for (const ParameterId id : {ParameterId::alpha, ParameterId::theta, ParameterId::beta})
        if (was_tuned(result, id))
            options += fmt::format(" --{} {:.3g}", parameter(id).key, *result.values[id]);
    print(fmt::format("\n{}: --technique {}{}\nrms error of T {:.4g}, before {:.4g}; failures {}\n",
                      technique.name, technique.id, options, result.error, result.error_before,
                      percent(result.failure_rate)));
}

void print_overdraw(const std::vector<OverdrawTrial>& trials, double most_failures) {
    print(fmt::format(
        "\nSmallest safe moment bias for each overdraw (thin fragments in two layers, up to {} rays each)\n{:>10}{:>12}\n",
        OVERDRAW_RAYS, "fragments", "alpha"));
    for (const OverdrawTrial& trial : trials) {
        const auto least = least_safe_bias(trial.result, most_failures);
        print(fmt::format("{:>10}{:>12}\n", trial.fragments, least ? fmt::format("{:.2g}", *least) : "none"));
    }
}

class TuneCommand : public ParsedCommand {
public:
    explicit TuneCommand(CLI::App& app) : ParsedCommand(app) {
        CLI::Option* scene = add_scene(app, scene_);
        add_size(app, size_);
        add_gl(app);
        CLI::Option* ray = app.add_option("--ray", ray_, "JSON file with a view ray, instead of a scene");
        CLI::Option* random = add_parsed<std::optional<int>>(
            app, "--random", random_, "number of random rays with 2 to 5 fragments, instead of a scene",
            [](const std::string& text) {
                return parse_count(text, RAY_COUNT.what, RAY_COUNT.least, RAY_COUNT.most);
            });
        ray->excludes(scene, random);
        random->excludes(scene);
        add_techniques(app, techniques_, "id of a technique with moments [power8-32]");
        add_parsed<double>(app, "--max-failures", max_failures_, "highest failure rate of a safe bias",
                           parse_rate)
            ->default_str("0.001");
        add_seed(app, seed_);
        parameters_.add_to(app);
    }

    void refuse_ignored() const override {
        refuse_ignored_options(app(), {{"--size", !of_scene(), "without a scene"},
                                       {"--gl", !of_scene(), "without a scene"},
                                       {"--seed", !random_, "without --random"}});
        refuse_ignored_parameters(
            parameters_, {.techniques = {},
                          .others = reconstruction_parameters(techniques_of(techniques_, "power8-32")),
                          .order = of_scene(),
                          .mesh = of_scene() && has_mesh_file(scene_)});
    }

    FileUse files() const override {
        FileUse use = {scene_files(scene_)};
        use.inputs.push_back(ray_);
        return use;
    }

    void run() const override {
        TuneOptions tuning;
        const auto chosen = techniques_of(techniques_, "power8-32");
        if (chosen.size() != 1)
            throw Error("tune takes one technique at a time; give --technique a single id.");
        tuning.technique = chosen.front();
        if (!tuning.technique->has_moments())
            throw Error(fmt::format("'{}' has no parameters to tune; choose a technique with moments.",
                                    tuning.technique->id));
        tuning.values = parameters_.over();
        refuse_nonsense({&tuning.technique, 1}, tuning.values);
        tuning.most_failures = max_failures_;
        const std::vector<ViewRay> rays = this->rays(tuning);
        std::optional<TuneResult> result;
        std::optional<std::vector<OverdrawTrial>> by_overdraw;
        {
            Progress progress("Tuning");
            const auto show = [&](std::size_t done, std::size_t all) { progress.show(done, all); };
            result = tune(rays, tuning, progress.stop(), show);
            if (result && tuning.technique->moment_kernel().bits == 16 && random_)
                by_overdraw = tune_by_overdraw(tuning, OVERDRAW_RAYS, seed_, progress.stop(), show);
            progress.require_finished();
        }
        print_trials(*tuning.technique, *result);
        if (by_overdraw) print_overdraw(*by_overdraw, tuning.most_failures);
        print_result(*tuning.technique, *result);
    }

private:
    bool of_scene() const { return !random_ && ray_.empty(); }

    std::vector<ViewRay> rays(const TuneOptions& tuning) const {
        if (random_) return tuning_rays(*random_, seed_);
        if (!ray_.empty()) return {read_ray_file(ray_)};
        return scene_rays(tuning);
    }

    // The rays of all pixels of a small picture, which cover the scene evenly.
    std::vector<ViewRay> scene_rays(const TuneOptions& tuning) const {
        Progress progress("Looking at the scene");
        const Scene scene = load_scene_and_warn(scene_, tuning.values, progress);
        const auto context = make_headless_context({16, 16});
        Renderer renderer;
        renderer.set_scene(scene);
        renderer.render({scene.camera, size_, &require_technique("sorted"), tuning.values});
        std::vector<ViewRay> rays;
        for (PixelCapture& capture : renderer.capture_region({0, 0}, size_))
            rays.push_back(std::move(capture.ray));
        progress.require_finished();
        return rays;
    }

    std::string scene_ = STANDARD_SCENE;
    glm::ivec2 size_ = {96, 54};
    std::string ray_;
    std::optional<int> random_;
    TechniqueIds techniques_;
    double max_failures_ = 0.001;
    std::uint32_t seed_ = 1;
    ParameterOptions parameters_;
};

}  // namespace

std::unique_ptr<ParsedCommand> add_tune(CLI::App& app) {
    return std::make_unique<TuneCommand>(app);
}

}  // namespace momentscope
