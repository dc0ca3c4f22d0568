#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/gl_context.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "core/error.hpp"
#include "core/inspect/curve_output.hpp"
#include "core/inspect/error_breakdown.hpp"
#include "core/inspect/sharp_bounds.hpp"
#include "core/inspect/steps.hpp"
#include "core/output_file.hpp"
#include "core/ray/ray_json.hpp"
#include "core/ray/submission_order.hpp"
#include "core/render/light_view.hpp"
#include "core/scene/camera.hpp"
#include "core/shadow/cast_ray.hpp"

namespace momentscope {

namespace {

constexpr int MAX_SAMPLES = 1'000'000;

/// What is inspected: a pixel, or what lights it.
struct Subject {
    PixelCapture capture;
    std::optional<LightView> light;
    CastLight cast = {};  // of the light
};

// nullopt for what is seen of the pixel.
std::optional<std::size_t> parse_receiver(const std::string& text, const ViewRay& ray) {
    if (text.empty()) return std::nullopt;
    if (text == "surface") return OPAQUE_SURFACE;
    const int number = parse_count(text, "receiver", 1, MAX_SAMPLES);
    const std::vector<std::size_t> order = front_to_back(ray);
    if (static_cast<std::size_t>(number) > order.size())
        throw Error(fmt::format("The pixel has {}; give a --receiver from 1 to their number, or surface.",
                                fragment_count_text(order.size())));
    return order[static_cast<std::size_t>(number - 1)];
}

Subject capture_scene_pixel(const Options& options, const Configuration& configuration) {
    const glm::ivec2 size = parse_size(options.size.empty() ? STANDARD_SIZE : options.size);
    std::optional<glm::ivec2> pixel;
    if (!options.pixel.empty()) pixel = parse_pixel(options.pixel, size);
    Progress progress("Inspecting");
    const Scene scene = load_scene_option(options, configuration.values, progress);
    const auto context = make_gl_context("osmesa", {16, 16});
    Renderer renderer;
    renderer.set_scene(scene);
    ParameterValues values = configuration.values;
    if (options.light) values.set(ParameterId::shadows, 1.0f);
    renderer.render({scene.camera, size, configuration.technique, values});
    const glm::ivec2 at = pixel.value_or(picked_pixel(scene, size));
    Subject subject = {.capture = renderer.capture_pixel(at), .light = {}};
    progress.require_finished();
    if (!options.light) return subject;
    subject.light =
        view_from_light(renderer, at, subject.capture, parse_receiver(options.receiver, subject.capture.ray));
    if (!subject.light)
        throw Error(fmt::format("Pixel {},{} shows nothing that could receive light; give another --pixel.",
                                at.x, at.y));
    subject.cast =
        cast_light(scene, subject.light->world, renderer.shadow_maps()->frame().position, LIGHT_SLACK);
    progress.require_finished();
    return subject;
}

Subject ray_of_file(const std::string& path, const ParameterValues& values) {
    Subject subject;
    subject.capture.ray = submitted_in(read_ray_file(path), submission_order(values));
    return subject;
}

std::string text_of_light(const LightView& light, const CastLight& cast) {
    const LightBreakdown& v = light.breakdown;
    return fmt::format(
        "Receiver: {}, at depth {:.5f} seen from the light, {} in {} texels.\n"
        "Transparent casters let through {:.4f} (truth {:.4f}), opaque ones {:.4f} (truth {:.4f}); shaded with {:.4f}.\n"
        "A ray through all triangles, without a map: {}.\n{}\n",
        light.receiver, static_cast<double>(light.bundle.place.depth),
        fragment_count_text(light.ray.fragments.size()), light.bundle.texels.size(), v.transmittance,
        v.true_transmittance, 1 - v.shadowed, 1 - v.true_shadowed, light.visibility,
        cast.shadowed ? "an opaque caster is met" : fmt::format("{:.4f}", cast.transmittance), v.sentence);
}

// One line for each technique, below a table of curves.
std::string text_of_breakdowns(const PixelCapture& capture, const std::vector<Curve>& curves) {
    std::string text;
    for (const Curve& curve : curves)
        text += fmt::format(
            "{}: {}\n", curve_name(curve, curves),
            pixel_error_breakdown(capture.ray, *curve.technique, curve.values, capture.behind).sentence);
    return text;
}

std::string text_of_steps(const std::vector<Curve>& curves, const std::vector<float>& depths) {
    std::string text;
    for (const Curve& curve : curves) {
        if (curve.technique->kernel == nullptr)
            throw Error(fmt::format("'{}' has no steps: it has no moments to reconstruct from.",
                                    curve.technique->id));
        for (const float depth : depths) text += steps_to_text(reconstruction_steps(curve, depth));
    }
    return text;
}

void add_sharp_bounds(Curve& curve, const ViewRay& ray) {
    auto bounds = sharp_bounds(ray, *curve.technique, curve.parameters, curve.depth);
    if (!bounds)
        throw Error(
            fmt::format("The linear program of the sharp bounds of '{}' found no solution on this ray.",
                        curve.technique->id));
    curve.sharp_lower = std::move(bounds->lower);
    curve.sharp_upper = std::move(bounds->upper);
}

}  // namespace

void run_inspect(const Options& options) {
    const std::string format = options.format.empty() ? "json" : options.format;
    if (format != "json" && format != "csv" && format != "table")
        throw Error(fmt::format("There is no format '{}'; use json, csv or table.", format));
    auto configurations = parse_configurations(options, "power6-32");
    if (options.steps && options.sharp_bounds)
        throw Error("Sharp bounds belong to curves; leave --steps or --sharp-bounds out.");
    const std::vector<float> depths = options.steps && options.depths.empty() ? std::vector<float>{0}
                                      : options.depths.empty()
                                          ? even_depths(static_cast<std::size_t>(parse_count(
                                                options.samples, "number of samples", 2, MAX_SAMPLES)))
                                          : parse_depths(options.depths);
    if (options.light && configurations.size() > 1)
        throw Error(
            "The light's map has one technique; give a --shadow-technique, and a single --technique for the picture.");
    if (!options.output.empty()) require_writable(options.output);
    const Subject subject = options.ray.empty() ? capture_scene_pixel(options, configurations.front())
                                                : ray_of_file(options.ray, configurations.front().values);
    const ViewRay& ray = subject.light ? subject.light->ray : subject.capture.ray;
    if (subject.light) configurations = {subject.light->configuration};
    std::vector<Curve> curves;
    curves.reserve(configurations.size());
    for (const Configuration& one : configurations)
        curves.push_back(sample_curve(ray, *one.technique, one.values, depths));
    if (options.sharp_bounds)
        for (Curve& curve : curves) add_sharp_bounds(curve, ray);
    const std::string text =
        options.steps      ? text_of_steps(curves, depths)
        : format == "json" ? curves_to_json(ray, curves)
        : format == "csv"
            ? curves_to_csv(curves)
            : curves_to_table(ray, curves) + (subject.light ? text_of_light(*subject.light, subject.cast)
                                                            : text_of_breakdowns(subject.capture, curves));
    if (options.output.empty())
        print(text);
    else
        write_file(text, options.output);
}

}  // namespace momentscope
