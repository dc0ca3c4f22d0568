#include <fmt/format.h>

#include <algorithm>

#include "app/commands.hpp"
#include "app/gl_context.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "core/error.hpp"
#include "core/ray/ray_json.hpp"
#include "core/render/renderer.hpp"
#include "core/stress/tune.hpp"
#include "core/techniques/moment_kernel.hpp"

namespace momentscope {

namespace {

constexpr int OVERDRAW_RAYS = 300;

// Pixels on a grid, which see the scene evenly.
std::vector<ViewRay> scene_rays(const Options& options, const TuneOptions& tuning) {
    const glm::ivec2 size = parse_size(options.size.empty() ? "96x54" : options.size);
    Progress progress("Looking at the scene");
    const Scene scene = load_scene_option(options, tuning.values, progress);
    const auto context = make_gl_context("osmesa", {16, 16});
    Renderer renderer;
    renderer.set_scene(scene);
    renderer.render({scene.camera, size, &require_technique("sorted"), tuning.values});
    std::vector<ViewRay> rays;
    for (PixelCapture& capture : renderer.capture_region({0, 0}, size))
        rays.push_back(std::move(capture.ray));
    progress.require_finished();
    return rays;
}

std::string percent(double rate) {
    return rate > 0 ? fmt::format("{:.2g} %", 100 * rate) : "0 %";
}

const char* preset_name(const Technique& technique, const Trial& trial) {
    if (trial.parameter != ParameterId::alpha) return "";
    if (trial.value == technique.recommended_bias) return "  (Table 1)";
    return trial.value == technique.robust_bias ? "  (preset robust)" : "";
}

// One table per parameter. What exact arithmetic on the stored moments fails, no solver mends.
void print_trials(const Technique& technique, const TuneResult& result) {
    for (const ParameterId id : {ParameterId::alpha, ParameterId::theta, ParameterId::beta}) {
        if (!technique.uses(id)) continue;
        const Parameter& row = parameter(id);
        const bool judged = id == ParameterId::alpha;
        print(fmt::format("\n{} --{}{}\n{:>12}  rms error of T{}\n", row.name, row.key,
                          judged ? " (at beta = 0)" : "", "value",
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
            "\nNo moment bias keeps the failure rate below the bound; this one fails least ({}).\n",
            percent(result.failure_rate)));
    std::string options;
    for (const ParameterId id : {ParameterId::alpha, ParameterId::theta, ParameterId::beta})
        if (technique.uses(id)) options += fmt::format(" --{} {:.3g}", parameter(id).key, *result.values[id]);
    print(fmt::format("\n{}: --technique {}{}\nrms error of T {:.4g}, before {:.4g}; failures {}\n",
                      technique.name, technique.id, options, result.error, result.error_before,
                      percent(result.failure_rate)));
}

void print_overdraw(const std::vector<OverdrawTrial>& trials, double most_failures) {
    print(fmt::format(
        "\nSmallest safe moment bias by overdraw (thin fragments in two layers, up to {} rays each)\n{:>10}{:>12}\n",
        OVERDRAW_RAYS, "fragments", "alpha"));
    for (const OverdrawTrial& trial : trials) {
        const auto least = least_safe_bias(trial.result, most_failures);
        print(fmt::format("{:>10}{:>12}\n", trial.fragments, least ? fmt::format("{:.2g}", *least) : "none"));
    }
}

}  // namespace

void run_tune_command(const Options& options) {
    TuneOptions tuning;
    const auto chosen = parse_techniques(options, "power8-32");
    if (chosen.size() != 1) throw Error("tune takes one technique at a time; give --technique one id.");
    tuning.technique = chosen.front();
    if (tuning.technique->kernel == nullptr)
        throw Error(fmt::format("'{}' has no parameters to tune; choose a technique with moments.",
                                tuning.technique->id));
    tuning.values = parse_parameters(options);
    tuning.most_failures = parse_rate(options.max_failures);
    const std::uint32_t seed = parse_seed(options.seed);
    const bool of_scene = options.random.empty() && options.ray.empty();
    std::vector<ViewRay> rays;
    if (!options.random.empty())
        rays = tuning_rays(parse_ray_count(options.random), seed);
    else if (!options.ray.empty())
        rays.push_back(read_ray_file(options.ray));
    if (of_scene) rays = scene_rays(options, tuning);
    std::optional<TuneResult> result;
    std::optional<std::vector<OverdrawTrial>> by_overdraw;
    {
        Progress progress("Tuning");
        const auto show = [&](std::size_t done, std::size_t all) { progress.show(done, all); };
        result = tune(rays, tuning, progress.stop(), show);
        if (result && tuning.technique->kernel->bits == 16 && !options.random.empty())
            by_overdraw = tune_by_overdraw(tuning, OVERDRAW_RAYS, seed, progress.stop(), show);
        progress.require_finished();
    }
    print_trials(*tuning.technique, *result);
    if (by_overdraw) print_overdraw(*by_overdraw, tuning.most_failures);
    print_result(*tuning.technique, *result);
}

}  // namespace momentscope
