#include <fmt/format.h>

#include "app/command.hpp"
#include "app/gl_context.hpp"
#include "app/ignored_options.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "core/inspect/error_breakdown.hpp"
#include "core/inspect/sharp_bounds.hpp"
#include "core/inspect/step_texts.hpp"
#include "core/ray/ray_json.hpp"
#include "core/ray/submission_order.hpp"
#include "core/render/view_from_light.hpp"
#include "core/report/curve_output.hpp"
#include "core/scene/camera.hpp"
#include "core/shadow/cast_ray.hpp"
#include "core/support/error.hpp"
#include "core/support/output_file.hpp"
#include "core/support/parse_number.hpp"

namespace momentscope {

namespace {

constexpr int MAX_SAMPLES = 1'000'000;

/// What is inspected: a pixel, or the light that reaches it.
struct Subject {
    PixelCapture capture;
    std::optional<LightView> light;
    CastLight cast = {};  // the ray of the light through all triangles
};

enum class Format { json, csv, table };

Format parse_format(const std::string& text) {
    if (text == "json") return Format::json;
    if (text == "csv") return Format::csv;
    if (text == "table") return Format::table;
    throw Error(fmt::format("There is no format '{}'; use json, csv or table.", text));
}

// "z1,z2,...", each in [-1, 1].
std::vector<float> parse_depths(const std::string& text) {
    std::vector<float> depths;
    for (const std::string& part : split_list({text})) {
        const auto depth = parse_number<float>(part);
        if (!depth || !(*depth >= -1 && *depth <= 1))
            throw Error(fmt::format(
                "The depth '{}' is not a number from -1 to 1; give --depths such as -0.5,0,0.25.", part));
        depths.push_back(*depth);
    }
    return depths;
}

// nullopt: the visible surface of the pixel.
std::optional<std::size_t> parse_receiver(const std::string& text, const ViewRay& ray) {
    if (text.empty()) return std::nullopt;
    if (text == "surface") return OPAQUE_SURFACE;
    const int number = parse_count(text, "receiver", 1, MAX_SAMPLES);
    const std::vector<std::size_t> order = front_to_back(ray);
    if (static_cast<std::size_t>(number) > order.size())
        throw Error(fmt::format("The pixel has {}; give --receiver a number of a fragment, or surface.",
                                fragment_count_text(order.size())));
    return order[static_cast<std::size_t>(number - 1)];
}

std::string text_of_light(const LightView& light, const CastLight& cast) {
    const LightBreakdown& v = light.breakdown;
    return fmt::format(
        "Receiver: {}, at depth {:.5f} seen from the light, with {} in {} texels.\n"
        "Transparent casters let through {:.4f} (truth {:.4f}), opaque ones {:.4f} (truth {:.4f}); shaded with {:.4f}.\n"
        "A ray through all triangles, without a map, gives: {}.\n{}\n",
        light.receiver, static_cast<double>(light.bundle.place.depth),
        fragment_count_text(light.ray.fragments.size()), light.bundle.texels.size(), v.transmittance,
        v.true_transmittance, 1 - v.shadowed, 1 - v.true_shadowed, light.visibility,
        cast.shadowed ? "it meets an opaque caster" : fmt::format("{:.4f}", cast.transmittance), v.sentence);
}

// One line for each technique, printed below a table of curves.
std::string text_of_breakdowns(const PixelCapture& capture, const std::vector<Curve>& curves) {
    std::string text;
    for (const Curve& curve : curves)
        text += fmt::format(
            "{}: {}\n", curve_name(curve, curves),
            pixel_error_breakdown(capture.ray, *curve.technique, curve.values, capture.behind).sentence);
    return text;
}

std::string text_of_steps(const ViewRay& ray, const std::vector<Curve>& curves,
                          const std::vector<float>& depths) {
    std::string text;
    for (const Curve& curve : curves) {
        if (!curve.technique->has_moments())
            throw Error(
                fmt::format("'{}' has no steps, because it has no moments; choose a technique with moments.",
                            curve.technique->id));
        for (const float depth : depths)
            text += steps_to_text(reconstruction_steps(curve, depth, fragment_at(ray, depth)));
    }
    return text;
}

void add_sharp_bounds(Curve& curve, const ViewRay& ray) {
    auto bounds = sharp_bounds(ray, *curve.technique, curve.parameters, curve.depth);
    if (!bounds)
        throw Error(fmt::format(
            "The linear program for the sharp bounds of '{}' has no solution on this ray; leave --sharp-bounds out.",
            curve.technique->id));
    curve.sharp_lower = std::move(bounds->lower);
    curve.sharp_upper = std::move(bounds->upper);
}

class Inspect : public ParsedCommand {
public:
    explicit Inspect(CLI::App& app) : ParsedCommand(app) {
        CLI::Option* scene = add_scene(app, scene_);
        add_size(app, size_);
        add_gl(app);
        CLI::Option* pixel =
            app.add_option("--pixel", pixel_.text, "pixel of the picture, such as 320,200 [the scene's own]");
        app.add_option("--ray", ray_, "JSON file with a view ray, instead of a pixel of a scene")
            ->excludes(scene, pixel);
        add_techniques(
            app, techniques_,
            "ids of techniques, or configurations such as at:nodes=8, separated by commas or in repeated options");
        add_count(app, "--samples", samples_, "number of even depths from -1 to 1",
                  {"number of samples", 2, MAX_SAMPLES});
        add_parsed<std::vector<float>>(app, "--depths", depths_,
                                       "depths instead of --samples, such as -0.5,0,0.25", parse_depths);
        app.add_flag("--steps", steps_,
                     "print the steps of the reconstruction at --depths (0 if left out) instead of curves");
        app.add_flag("--sharp-bounds", sharp_bounds_,
                     "add the least and the greatest absorbance that the moments allow");
        app.add_flag(
            "--light", light_,
            "print what the light's map stores about the surface in the pixel, instead of the eye's ray");
        app.add_option(
            "--receiver", receiver_,
            "with --light: the number of a fragment, from 1 for the nearest, or surface for the opaque one "
            "[the visible one]");
        add_parsed<Format>(app, "--format", format_, "json, csv or table [json]", parse_format);
        app.add_option("-o,--output", output_, "file to write instead of standard output");
        parameters_.add_to(app);
    }

    void refuse_ignored() const override {
        const bool ray = !ray_.empty();
        refuse_ignored_options(app(),
                               {{"--size", ray, "together with --ray, because a view ray has no picture"},
                                {"--gl", ray, "together with --ray, because a view ray has no picture"},
                                {"--samples", !depths_.empty(), "together with --depths"},
                                {"--samples", steps_, "together with --steps, which reads --depths"},
                                {"--format", steps_, "together with --steps, which prints text"},
                                {"--light", ray, "together with --ray, because a view ray has no light"},
                                {"--receiver", !light_, "without --light"}});
        ParameterReading reading = {.techniques = techniques_in(configurations()),
                                    .picture = !ray,
                                    .order = true,
                                    .mesh = !ray && has_mesh_file(scene_)};
        if (light_) reading.others = {SHADOW_PARAMETERS.begin(), SHADOW_PARAMETERS.end()};
        refuse_ignored_parameters(parameters_, reading);
    }

    FileUse files() const override {
        FileUse use = {scene_files(scene_), {{"-o", output_}}};
        use.inputs.push_back(ray_);
        return use;
    }

    void run() const override {
        auto configurations = this->configurations();
        if (steps_ && sharp_bounds_)
            throw Error(
                "Sharp bounds belong to curves, which --steps does not print; leave one of the two options out.");
        if (light_ && configurations.size() > 1)
            throw Error(
                "The light's map has one technique, chosen by --shadow-technique; give a single --technique for the picture.");
        if (!output_.empty()) require_writable(output_);
        const Subject subject = ray_.empty() ? capture_scene_pixel(configurations.front())
                                             : ray_of_file(configurations.front().values);
        const ViewRay& ray = subject.light ? subject.light->ray : subject.capture.ray;
        if (subject.light) configurations = {subject.light->configuration};
        const std::vector<float> depths = this->depths();
        std::vector<Curve> curves;
        curves.reserve(configurations.size());
        for (const Configuration& one : configurations)
            curves.push_back(sample_curve(ray, *one.technique, one.values, depths));
        if (sharp_bounds_)
            for (Curve& curve : curves) add_sharp_bounds(curve, ray);
        const std::string text = steps_ ? text_of_steps(ray, curves, depths) : text_of(subject, ray, curves);
        if (output_.empty())
            print(text);
        else
            write_file(text, output_);
    }

private:
    std::vector<Configuration> configurations() const {
        return configurations_of(techniques_, "power6-32", parameters_.over());
    }

    std::vector<float> depths() const {
        if (!depths_.empty()) return depths_;
        return steps_ ? std::vector<float>{0} : even_depths(static_cast<std::size_t>(samples_));
    }

    Subject capture_scene_pixel(const Configuration& configuration) const {
        std::optional<glm::ivec2> pixel;
        if (pixel_) pixel = pixel_.within(size_);
        Progress progress("Inspecting");
        const Scene scene = load_scene_and_warn(scene_, configuration.values, progress);
        const auto context = make_headless_context({16, 16});
        Renderer renderer;
        renderer.set_scene(scene);
        ParameterValues values = configuration.values;
        if (light_) values.turn(ParameterId::shadows, true);
        renderer.render({scene.camera, size_, configuration.technique, values});
        const glm::ivec2 at = pixel.value_or(picked_pixel(scene, size_));
        Subject subject = {.capture = renderer.capture_pixel(at), .light = {}};
        progress.require_finished();
        if (!light_) return subject;
        subject.light =
            view_from_light(renderer, at, subject.capture, parse_receiver(receiver_, subject.capture.ray));
        if (!subject.light)
            throw Error(fmt::format(
                "Pixel {},{} shows nothing that could receive light; give another --pixel.", at.x, at.y));
        subject.cast =
            cast_light(scene, subject.light->world, renderer.shadow_maps()->frame().position, LIGHT_SLACK);
        progress.require_finished();
        return subject;
    }

    Subject ray_of_file(const ParameterValues& values) const {
        Subject subject;
        subject.capture.ray = submitted_in(read_ray_file(ray_), submission_order(values));
        return subject;
    }

    std::string text_of(const Subject& subject, const ViewRay& ray, const std::vector<Curve>& curves) const {
        switch (format_) {
            case Format::json:
                return curves_to_json(ray, curves);
            case Format::csv:
                return curves_to_csv(curves);
            case Format::table:
                break;
        }
        return curves_to_table(ray, curves) + (subject.light ? text_of_light(*subject.light, subject.cast)
                                                             : text_of_breakdowns(subject.capture, curves));
    }

    std::string scene_ = STANDARD_SCENE;
    glm::ivec2 size_ = PICTURE_SIZE;
    PixelOption pixel_;
    std::string ray_;
    TechniqueIds techniques_;
    int samples_ = 512;
    std::vector<float> depths_;
    bool steps_ = false, sharp_bounds_ = false, light_ = false;
    std::string receiver_;
    Format format_ = Format::json;
    std::string output_;
    ParameterOptions parameters_;
};

}  // namespace

std::unique_ptr<ParsedCommand> add_inspect(CLI::App& app) {
    return std::make_unique<Inspect>(app);
}

}  // namespace momentscope
