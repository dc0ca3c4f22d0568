#include "core/figures/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "core/inspect/curve.hpp"
#include "core/inspect/pixel_state_curve.hpp"
#include "core/ray/random_ray.hpp"

namespace momentscope {

using enum ParameterId;

ViewRay even_sheets(int count) {
    ViewRay ray;
    for (int i = 0; i < count; ++i)
        ray.fragments.push_back(
            plain_fragment(-0.8f + 1.6f * static_cast<float>(i) / static_cast<float>(count - 1), 0.5f,
                           static_cast<std::size_t>(i)));
    return ray;
}

ViewRay uneven_sheets() {
    ViewRay ray;
    for (const auto& [depth, opacity] :
         {std::pair(-0.7f, 0.4f), std::pair(-0.55f, 0.5f), std::pair(0.0f, 0.35f), std::pair(0.35f, 0.6f),
          std::pair(0.8f, 0.5f)})
        ray.fragments.push_back(plain_fragment(depth, opacity, ray.fragments.size()));
    return ray;
}

namespace {

constexpr std::size_t DEPTHS = 512;

// The mean distance of T from the truth, over the depth range.
double curve_error(const ViewRay& ray, const char* technique, const ParameterSettings& settings) {
    const Curve curve =
        sample_curve(ray, require_technique(technique), values_with(settings), even_depths(DEPTHS));
    double sum = 0;
    for (std::size_t i = 0; i < curve.depth.size(); ++i)
        sum += std::abs(std::exp(-static_cast<double>(curve.reconstructed[i])) - std::exp(-curve.truth[i]));
    return sum / DEPTHS;
}

struct Ranked {
    const char* name;
    double value;
};

// Checks that each value is less than the previous one.
ClaimResult falling(std::string claim, const std::vector<Ranked>& values, std::string remark = "") {
    ClaimResult result = {std::move(claim), true, "", std::move(remark)};
    for (std::size_t i = 0; i < values.size(); ++i) {
        result.agrees &= i == 0 || values[i].value < values[i - 1].value;
        result.numbers += fmt::format("{}{} {:.3g}", i == 0 ? "" : ", ", values[i].name, values[i].value);
    }
    return result;
}

}  // namespace

std::vector<ClaimResult> measure_overestimation(RenderSource& setups) {
    const ViewRay ray = setups.picked_ray({"cloud", "power6-32"});
    const Curve curve = sample_curve(ray, require_technique("power6-32"), {}, even_depths(DEPTHS));
    int outside = 0;
    for (std::size_t i = 0; i < curve.depth.size(); ++i) {
        const auto truth = static_cast<float>(curve.truth[i]);
        const float slack = 2e-3f * static_cast<float>(curve.total_absorbance);
        outside += truth < curve.beta0[i] - slack || truth > curve.beta1[i] + slack ? 1 : 0;
    }
    return {{"β = 0 and β = 1 bound the absorbance from below and above", outside == 0,
             fmt::format("{} of {} depths outside", outside, DEPTHS)},
            falling("β = 0.25 is closer to the truth than the upper bound",
                    {{"mean error of T for β = 1:", curve_error(ray, "power6-32", {{beta, 1}})},
                     {"β = 0.25:", curve_error(ray, "power6-32", {{beta, 0.25f}})}}),
            falling("β = 0.25 is also closer than the lower bound",
                    {{"β = 0:", curve_error(ray, "power6-32", {{beta, 0}})},
                     {"β = 0.25:", curve_error(ray, "power6-32", {{beta, 0.25f}})}})};
}

std::vector<ClaimResult> measure_ideal(RenderSource&) {
    const ViewRay two = even_sheets(2), three = even_sheets(3), four = even_sheets(4);
    const auto pair = [](const char* count, const ViewRay& ray, const char* power, const char* trig) {
        return falling(
            fmt::format("with {} sheets, bias harms power moments more than trigonometric ones", count),
            {{power, curve_error(ray, power, {})}, {trig, curve_error(ray, trig, {})}},
            power == std::string_view("power4-32") ? "Here Table 1 has nearly the same bias for both" : "");
    };
    return {pair("two", two, "power4-32", "trig2-32"), pair("three", three, "power6-32", "trig3-32"),
            pair("four", four, "power8-32", "trig4-32")};
}

std::vector<ClaimResult> measure_wrapping(RenderSource&) {
    const ViewRay ray = uneven_sheets();
    const auto steepest = [&](float angle) {
        const Curve curve = sample_curve(ray, require_technique("trig3-32"), values_with({{theta, angle}}),
                                         even_depths(DEPTHS));
        float most = 0;
        for (std::size_t i = 1; i < curve.depth.size(); ++i)
            most = std::max(most, curve.reconstructed[i] - curve.reconstructed[i - 1]);
        return static_cast<double>(most) * (DEPTHS - 1) / 2;
    };
    return {falling("a wider wrapping zone smooths the reconstruction: its steepest slope falls with θ",
                    {{"θ = 0.01π:", steepest(0.01f * std::numbers::pi_v<float>)},
                     {"θ = 0.1π:", steepest(0.1f * std::numbers::pi_v<float>)},
                     {"θ = 0.4π:", steepest(0.4f * std::numbers::pi_v<float>)}})};
}

std::vector<ClaimResult> measure_ship(RenderSource& setups) {
    const auto error = [&](const char* technique, ParameterSettings settings = {}) {
        return setups.error({"ship", technique, std::move(settings)});
    };
    const double wboit = error("wboit"), power4 = error("power4-16"), power6 = error("power6-32"),
                 trig3 = error("trig3-32"), mlab = error("mlab"), mlab6 = error("mlab", {{layers, 6}}),
                 at = error("at");
    return {
        falling(
            "moment-based transparency with four power moments captures occlusion far better than weighted "
            "blending",
            {{"wboit", wboit}, {"power4-16", power4}}),
        falling("six power moments come close to the truth, four are plausible",
                {{"power4-16", power4}, {"power6-32", power6}}),
        falling("three trigonometric moments remove nearly all errors",
                {{"power6-32", power6}, {"trig3-32", trig3}},
                fmt::format("In our fog they do not help; four have {:.3g}", error("trig4-32"))),
        falling("multi-layer alpha blending with four layers fails in the fog, and moments do better",
                {{"mlab, 4 layers", mlab}, {"power6-32", power6}}),
        falling("six layers do better than four", {{"4 layers", mlab}, {"6 layers", mlab6}}),
        falling("adaptive transparency is worse than multi-layer alpha blending",
                {{"at, 4 nodes", at}, {"mlab", mlab}})};
}

std::vector<ClaimResult> measure_teapots(RenderSource& setups) {
    const auto error = [&](const char* technique) { return setups.error({"teapots", technique}); };
    const double wboit = error("wboit"), power4 = error("power4-32"), power6 = error("power6-32");
    return {
        falling("weighted blending is worst, four power moments are plausible, six improve on them",
                {{"wboit", wboit}, {"power4-32", power4}, {"power6-32", power6}}),
        falling("multi-layer alpha blending performs well except at a curtain: it beats weighted blending",
                {{"wboit", wboit}, {"mlab, 4 layers", error("mlab")}}),
        falling("adaptive transparency has the same artifacts and others",
                {{"at, 4 nodes", error("at")}, {"mlab, 4 layers", error("mlab")}})};
}

namespace {

// The mean of the picture minus the mean of the truth.
double brightness(RenderSource& setups, const RenderSetup& setup) {
    const Image truth = setups.picture({setup.scene, "sorted"});
    const Image& shown = setups.picture(setup);
    double sum = 0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) sum += static_cast<double>(shown.pixels[i][c] - truth.pixels[i][c]) / 3;
    return sum / static_cast<double>(truth.pixels.size());
}

}  // namespace

std::vector<ClaimResult> measure_foliage(RenderSource& setups) {
    const RenderSetup without = {"foliage", "power6-32", {{renormalize, 0}}}, with = {"foliage", "power6-32"};
    const double dark = brightness(setups, without), mended = brightness(setups, with);
    return {{"without renormalisation the picture is too dark", dark < 0,
             fmt::format("mean difference in brightness {:+.4f}", dark)},
            {"renormalisation removes that", std::abs(mended) < std::abs(dark),
             fmt::format("{:+.4f} with it", mended)},
            falling("hashed alpha testing suits this case: its brightness is closer to the truth",
                    {{"difference in brightness: power6-32, without renormalisation", std::abs(dark)},
                     {"hashed", std::abs(brightness(setups, {"foliage", "hashed"}))}},
                    "This does not count its noise in a single frame")};
}

namespace {

constexpr double PERFECT = 1e-3;  // root mean square

}  // namespace

std::vector<ClaimResult> measure_spheres(RenderSource& setups) {
    const glm::vec4 around(0.3f, 0.2f, 0.7f, 0.8f);
    const auto error = [&](const char* technique, ParameterSettings settings = {}) {
        return setups.error({"spheres", technique, std::move(settings)}, Metric::rmse, around);
    };
    const ParameterSettings two_layers = {{layers, 2}};
    return {
        falling("blur at the intersections falls in this order (errors around them)",
                {{"power4-16", error("power4-16")},
                 {"trig3-16", error("trig3-16")},
                 {"power6-32", error("power6-32")},
                 {"trig4-32", error("trig4-32")},
                 {"mlab, 4 layers", error("mlab")}}),
        {"adaptive transparency with four nodes is perfect", error("at") < PERFECT,
         fmt::format("{:.3g}; perfect would be below {}", error("at"), PERFECT),
         "Our picture also shows back faces: six fragments for four nodes"},
        {"multi-layer alpha blending with two layers is perfect, too", error("mlab", two_layers) < PERFECT,
         fmt::format("{:.3g}", error("mlab", two_layers)), "The reason is the same"}};
}

std::vector<ClaimResult> measure_eight(RenderSource& setups) {
    std::vector<ClaimResult> results;
    for (const char* scene : {"cloud", "smoke", "teapots"})
        results.push_back(
            falling(fmt::format("on `{}` eight power moments are closer to the truth than six", scene),
                    {{"power6-32", setups.error({scene, "power6-32"})},
                     {"power8-32", setups.error({scene, "power8-32"})}}));
    results.push_back(falling("but they cannot handle intersections, unlike trigonometric moments",
                              {{"spheres: power8-32", setups.error({"spheres", "power8-32"})},
                               {"trig4-32", setups.error({"spheres", "trig4-32"})}}));
    return results;
}

std::vector<ClaimResult> measure_variants(RenderSource& setups) {
    const auto error = [&](const char* technique) { return setups.error({"ship", technique}); };
    return {
        falling("eight power moments improve slightly on six",
                {{"power6-32", error("power6-32")}, {"power8-32", error("power8-32")}},
                fmt::format(
                    "The bias is not the reason: with a fiftieth of it (--preset robust) eight have {:.3g}",
                    setups.error({"ship", "power8-32", {{preset, 1}}}))),
        falling("eight power moments are worse than three trigonometric ones",
                {{"power8-32", error("power8-32")}, {"trig3-32", error("trig3-32")}})};
}

std::vector<ClaimResult> measure_smoke(RenderSource& setups) {
    const double wboit = setups.error({"smoke", "wboit"}), mt = setups.error({"smoke", "mt"}),
                 two = setups.error({"smoke", "mt", {{beta, 0}, {moment_passes, TWO_PASSES}}});
    return {falling("Moment Transparency improves on weighted blending",
                    {{"wboit", wboit}, {"mt, β = 0.25", mt}}),
            falling("two moment passes improve on one",
                    {{"mt, β = 0", setups.error({"smoke", "mt", {{beta, 0}}})}, {"two passes, β = 0", two}})};
}

namespace {

// The mean error of T at the depths of the fragments, over random rays of n fragments.
double mean_error(int fragments, const ParameterSettings& settings) {
    const Technique& technique = require_technique("mt");
    const ParameterValues pixel_state = resolve(values_with(settings), technique).settings;
    RandomNumbers random(3);
    double sum = 0;
    int count = 0;
    for (int run = 0; run < 500; ++run) {
        const ViewRay ray = random_ray(random, fragments, 0.1f, 0.7f);
        std::vector<float> depths;
        for (const Fragment& f : ray.fragments) depths.push_back(f.depth);
        const std::vector<double> truth = true_absorbance(ray, depths);
        const std::vector<float> t = pixel_state_transmittance(ray, technique, pixel_state, depths);
        for (std::size_t i = 0; i < t.size(); ++i, ++count)
            sum += std::abs(static_cast<double>(t[i]) - std::exp(-truth[i]));
    }
    return sum / count;
}

}  // namespace

std::vector<ClaimResult> measure_samples(RenderSource&) {
    const ParameterSettings plain = {{beta, 0}}, over = {{beta, 0.25f}},
                            two = {{beta, 0}, {moment_passes, TWO_PASSES}};
    return {falling("Moment Transparency is good for only two and three fragments",
                    {{"8 fragments", mean_error(8, plain)},
                     {"3 fragments", mean_error(3, plain)},
                     {"2", mean_error(2, plain)}}),
            falling("with more fragments, an overestimation of 25 % improves the result",
                    {{"8 fragments: β = 0", mean_error(8, plain)}, {"β = 0.25", mean_error(8, over)}}),
            falling("with two fragments, two moment passes hide too much",
                    {{"2 fragments: two passes", mean_error(2, two)}, {"one", mean_error(2, plain)}}),
            falling("with more fragments, two moment passes improve on one",
                    {{"8 fragments: one pass", mean_error(8, plain)}, {"two", mean_error(8, two)}})};
}

std::vector<ClaimResult> measure_low(RenderSource& setups) {
    const double full = setups.error({"smoke", "mt"}),
                 eighth = setups.error({"smoke", "mt", {{resolution, 3}}});
    return {falling("moments at an eighth of the resolution cost quality", {{"1/8", eighth}, {"full", full}}),
            falling("they still improve on weighted blending",
                    {{"wboit", setups.error({"smoke", "wboit"})}, {"1/8", eighth}})};
}

}  // namespace momentscope
