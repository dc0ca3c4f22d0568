// shadow_test.cpp -- the light's frustum, its filter, mixtures of texels, rays to the light, and the
// sentences about receivers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "core/inspect/curve.hpp"
#include "core/ray/random_ray.hpp"
#include "core/render/view.hpp"
#include "core/scene/scenes.hpp"
#include "core/shadow/cast_ray.hpp"
#include "core/shadow/light_breakdown.hpp"
#include "core/shadow/shadow_filter.hpp"
#include "core/shadow/shadow_onset.hpp"
#include "tests/unit/expect_error.hpp"

namespace momentscope::test {
namespace {

TEST(ShadowFilter, IsAGaussianThatSumsToOne) {
    for (int radius = 0; radius <= MAX_SHADOW_RADIUS; ++radius) {
        const std::vector<float> weights = gaussian_weights(radius);
        ASSERT_EQ(weights.size(), static_cast<std::size_t>(2 * radius + 1));
        EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1, 1e-6);
        for (int k = 0; k < radius; ++k) {
            const auto at = static_cast<std::size_t>(k);
            EXPECT_EQ(weights[at], weights[weights.size() - 1 - at]);
            EXPECT_LT(weights[at], weights[at + 1]);
            // exp(-x^2 / 2) of two neighbours, with a deviation of half the radius.
            const double x = k - radius, y = x + 1, deviation = 0.5 * radius;
            EXPECT_NEAR(static_cast<double>(weights[at + 1] / weights[at]),
                        std::exp((x * x - y * y) / (2 * deviation * deviation)),
                        1e-4 * std::exp(4.0 / radius));
        }
    }
}

// The filter of the GL, which takes two passes and four fetches, computed texel by texel.
TEST(ShadowFilter, FootprintIsFilterAndInterpolationAtOnce) {
    constexpr int SIZE = 16, RADIUS = 3;
    const std::vector<float> gaussian = gaussian_weights(RADIUS);
    RandomNumbers random(1);
    for (int i = 0; i < 200; ++i) {
        const glm::vec2 place(random.uniform(0, SIZE), random.uniform(0, SIZE));
        std::vector<double> expected(SIZE * SIZE);
        const glm::vec2 below = glm::floor(place - 0.5f), part = place - 0.5f - below;
        const auto clamped = [](int x) { return std::clamp(x, 0, SIZE - 1); };
        for (int corner = 0; corner < 4; ++corner)
            for (int y = -RADIUS; y <= RADIUS; ++y)
                for (int x = -RADIUS; x <= RADIUS; ++x) {
                    const int column = clamped(clamped(static_cast<int>(below.x) + corner % 2) + x);
                    const int row = clamped(clamped(static_cast<int>(below.y) + corner / 2) + y);
                    expected[static_cast<std::size_t>(row * SIZE + column)] +=
                        static_cast<double>((corner % 2 == 1 ? part.x : 1 - part.x) *
                                            (corner / 2 == 1 ? part.y : 1 - part.y)) *
                        static_cast<double>(gaussian[static_cast<std::size_t>(x + RADIUS)] *
                                            gaussian[static_cast<std::size_t>(y + RADIUS)]);
                }
        const ShadowFootprint footprint = shadow_footprint(place, SIZE, RADIUS);
        double sum = 0;
        for (int y = 0; y < footprint.extent.y; ++y)
            for (int x = 0; x < footprint.extent.x; ++x) {
                const float weight = footprint.weights[static_cast<std::size_t>(y * footprint.extent.x + x)];
                const glm::ivec2 texel = footprint.corner + glm::ivec2(x, y);
                EXPECT_NEAR(static_cast<double>(weight),
                            expected[static_cast<std::size_t>(texel.y * SIZE + texel.x)], 1e-6);
                sum += static_cast<double>(weight);
            }
        EXPECT_NEAR(sum, 1, 1e-5) << "no texel outside of it counts";
    }
}

TEST(LightCamera, SeesEveryCasterWithinItsDepthRange) {
    for (const SceneEntry& entry : scene_entries()) {
        const Scene scene = entry.build();
        const Sphere casters = caster_bounds(scene);
        for (const std::optional<float> distance :
             {std::optional<float>(), std::optional(1.06f * casters.radius)}) {
            ShadowSettings settings = shadow_settings({}, scene.light);
            settings.distance = distance;
            const LightCamera frame = light_camera(settings, casters);
            for (const Object& object : scene.objects) {
                if (!object.casts_shadow) continue;
                const std::vector<glm::vec3>& positions = scene.meshes[object.mesh].positions;
                for (std::size_t i = 0; i < positions.size(); i += 17) {
                    const glm::vec3 world(object.model * glm::vec4(positions[i], 1));
                    const ShadowMapPosition place = light_place(frame, 1024, world);
                    ASSERT_TRUE(place.within) << entry.id;
                    ASSERT_LT(std::abs(place.depth), 1.0f) << entry.id;
                }
            }
        }
    }
}

TEST(LightCamera, RefusesALightAmongTheCasters) {
    ShadowSettings settings = shadow_settings({}, {});
    settings.distance = 1.0f;
    expect_error([&] { light_camera(settings, {glm::vec3(0), 2.0f}); }, "--light-distance of 2.1");
}

TEST(ShadowSettings, ThePlotOfOpaqueCastersHasTheBiasOfTheirMap) {
    const auto configuration_of = [](const char* id) {
        const auto row = static_cast<float>(&require_opaque_shadow(id) - opaque_shadows().data());
        return opaque_configuration(values_with({{ParameterId::opaque_shadow, row}}));
    };
    for (const auto& [id, technique, bias] : {std::tuple("hamburger-32", "power4-32", 3e-7f),
                                              {"hamburger-16", "power4-32", 6e-5f},
                                              {"hausdorff", "power4-32", 3e-7f},
                                              {"trigonometric", "trig2-32", 4e-7f}}) {
        const Configuration configuration = configuration_of(id);
        EXPECT_STREQ(configuration.technique->id, technique) << id;
        EXPECT_EQ(configuration.values[ParameterId::alpha], bias) << id;
    }
    EXPECT_EQ(configuration_of("trigonometric").values[ParameterId::theta], 0.314159265f);
    EXPECT_STREQ(configuration_of("pcf").technique->id, "sorted");
}

TEST(ShadowSettings, EveryChoiceMeansATechnique) {
    const Parameter& row = parameter(ParameterId::shadow_technique);
    for (std::size_t i = 0; i < row.choices.size(); ++i) {
        const Configuration configuration = light_configuration(
            values_with({{row.id, static_cast<float>(i)}, {ParameterId::shadow_beta, 0.5f}}));
        const std::string_view id = row.choices[i];
        if (id.starts_with("fourier-")) {
            EXPECT_STREQ(configuration.technique->id, "fourier");
            EXPECT_EQ(texel_numbers(configuration), id == "fourier-7" ? 7 : 15);
        } else if (id != "deep" && id != "none") {
            EXPECT_EQ(configuration.technique->id, id);
            EXPECT_EQ(configuration.values[ParameterId::beta], 0.5f);
            EXPECT_EQ(configuration.technique->id, row.choices[i]);
        }
    }
    for (const Technique* technique : moment_based_techniques()) {
        const bool offered =
            std::ranges::find(row.choices, std::string_view(technique->id)) != row.choices.end();
        EXPECT_EQ(offered, std::string_view(technique->id).find("-16") == std::string_view::npos)
            << technique->id;
    }
    const Parameter& opaque = parameter(ParameterId::opaque_shadow);
    ASSERT_EQ(opaque.choices.size(), opaque_shadows().size());
    for (std::size_t i = 0; i < opaque.choices.size(); ++i)
        EXPECT_STREQ(opaque.choices[i], opaque_shadows()[i].id);
    EXPECT_STREQ(shadow_settings({}, {}).opaque->id, "hamburger-16") << "the paper's choice";
    expect_error([] { require_opaque_shadow("psm"); }, "pcf");
}

TEST(FirstStaleStage, OfShadowsIsThatOfColours) {
    const View view = {{}, {64, 64}, &require_technique("power6-32"), {}};
    const auto changed = [&](View base, const ParameterSettings& settings) {
        View after = base;
        for (const auto& [id, value] : settings) after.parameters.set(id, value);
        return first_stale_stage(base, after);
    };
    using enum ParameterId;
    EXPECT_EQ(changed(view, {{shadows, 1}}), Stage::shading);
    EXPECT_EQ(changed(view, {{shadow_beta, 0.5f}}), Stage::nothing) << "without shadows";
    View lit = view;
    lit.parameters.set(shadows, 1.0f);
    for (const ParameterId id : SHADOW_PARAMETERS)
        EXPECT_EQ(changed(lit, {{id, parameter(id).minimum +
                                         (parameter(id).scale == Scale::whole ? 1.0f : 0.5f) *
                                             (parameter(id).scale != Scale::choice ? 1.0f : 0.0f)}}),
                  Stage::shading)
            << parameter(id).key;
    EXPECT_EQ(changed(lit, {{shadows, 0}}), Stage::shading);
    EXPECT_EQ(changed(lit, {{light_azimuth, Light().azimuth}}), Stage::shading) << "a scene may have another";
    EXPECT_EQ(changed(lit, {{beta, 0.5f}}), Stage::color) << "the eye's alone";
    EXPECT_EQ(changed(lit, {{theta, 0.5f}}), Stage::nothing) << "power moments read none";
    EXPECT_EQ(changed(lit, {{renormalize, 0}}), Stage::composite)
        << "nor is this any of the light's business";
    EXPECT_EQ(changed(lit, {{solver, 1}}), Stage::color);
    EXPECT_EQ(changed(lit, {{alpha, 1e-3f}}), Stage::shading) << "alpha is that of both";
    View series = lit;
    series.parameters.set(shadow_technique, *parse_parameter(parameter(shadow_technique), "fourier-7"));
    EXPECT_EQ(changed(series, {{alpha, 1e-3f}}), Stage::color) << "which a series does not have";
    EXPECT_EQ(changed(series, {{lanczos, 1}}), Stage::shading);
    EXPECT_EQ(changed(series, {{coefficients, 1}}), Stage::nothing)
        << "the eye's series has other coefficients";
    lit.parameters.set(shadow_technique, *parse_parameter(parameter(shadow_technique), "trig3-32"));
    EXPECT_EQ(changed(lit, {{theta, 0.5f}}), Stage::shading) << "the light's moments do";
    lit.technique = &require_technique("wboit");
    EXPECT_EQ(changed(lit, {{shadow_beta, 0.5f}}), Stage::opaque) << "its first pass stores colours";
    View both = lit;
    both.technique = &require_technique("power4-32");
    both.parameters.set(shadow_beta, 0.7f);
    EXPECT_EQ(first_stale_stage(lit, both), Stage::opaque) << "new moments, and opaque surfaces shaded anew";
}

ShadowFilterSamples two_texels() {
    ShadowFilterSamples bundle;
    bundle.place = {{0, 0}, 0.5f, true};
    bundle.warp = {DepthWarp::Kind::linear, 1, 3};
    bundle.texels = {{0.75f, {{-0.5f, 1.5f, 0.5f}, {0.7f, 2.7f, 0.9f}}}, {0.25f, {{0.2f, 2.2f, 0.8f}}}};
    bundle.opaque = {{-0.2f, 0.75f}, {1.0f, 0.25f}};
    return bundle;
}

TEST(ShadowFilterSamples, MixesTexelsAsTheirWeightsSay) {
    const ShadowFilterSamples bundle = two_texels();
    EXPECT_NEAR(deep_transmittance(bundle, 0.5f), 0.75 * 0.5 + 0.25 * 0.2, 1e-6);
    EXPECT_NEAR(mixed_transmittance(bundle, 0.5f), std::pow(0.5, 0.75) * std::pow(0.2, 0.25), 1e-6);
    const ViewRay mixed = mixed_ray(bundle);
    const float depths[] = {0.5f};
    EXPECT_NEAR(std::exp(-true_absorbance(mixed, depths)[0]), mixed_transmittance(bundle, 0.5f), 1e-6);
    const ViewRay opaque = opaque_ray(bundle);
    EXPECT_NEAR(true_absorbance(opaque, depths)[0], 0.75, 1e-6);
    EXPECT_NEAR(total_absorbance(opaque), 1, 1e-6);
    EXPECT_LE(mixed_transmittance(bundle, 0.5f), deep_transmittance(bundle, 0.5f)) << "Jensen's inequality";
}

// A bundle of one texel with the sums of its fragments.
ShadowFilterSamples bundle_of(const ViewRay& ray, const Configuration& configuration, float depth) {
    ShadowFilterSamples bundle;
    bundle.place = {{0, 0}, depth, true};
    bundle.warp = {DepthWarp::Kind::linear, 1, 3};
    bundle.texels = {{1.0f, ray.fragments}};
    bundle.opaque = {{1.0f, 1.0f}};
    bundle.texel = require_opaque_shadow("hamburger-32").texel(1.0f);
    const MomentVector moments =
        sum_moments(ray, *configuration.technique, resolve(configuration.values, *configuration.technique));
    bundle.sums = {moments.b0};
    bundle.sums.insert(bundle.sums.end(), moments.b.begin(),
                       moments.b.begin() + texel_numbers(configuration) - 1);
    return bundle;
}

TEST(LightBreakdown, NamesLeakingAndSelfShadowing) {
    RandomNumbers random(2);
    const OpaqueShadow& opaque = require_opaque_shadow("hamburger-32");
    int leaks = 0, self = 0;
    for (int i = 0; i < 60; ++i) {
        const ViewRay ray = random_ray(random, 8, 0.1f, 0.5f);
        for (const float beta : {0.0f, 1.0f}) {
            const Configuration configuration = {&require_technique("power4-32"),
                                                 values_with({{ParameterId::beta, beta}})};
            const ShadowFilterSamples bundle = bundle_of(ray, configuration, ray.fragments[4].depth);
            const LightBreakdown breakdown = light_breakdown(bundle, configuration, opaque);
            double sum = 0;
            for (const Contribution& one : breakdown.contributions) sum += one.share;
            EXPECT_NEAR(sum, breakdown.true_transmittance - breakdown.transmittance, 1e-6);
            EXPECT_NEAR(breakdown.shadowed, 0, 1e-6);
            if (beta == 0) {
                EXPECT_GE(breakdown.transmittance, breakdown.true_transmittance - 1e-3)
                    << "a lower bound of A";
                leaks += breakdown.sentence.find("light leaks") != std::string::npos ? 1 : 0;
            } else {
                self += breakdown.sentence.find("self-shadowing") != std::string::npos ? 1 : 0;
            }
        }
    }
    EXPECT_GT(leaks, 40);
    EXPECT_GT(self, 20);
}

TEST(LightBreakdown, KnowsTheWholeOfLeakingPastOpaqueCasters) {
    ShadowFilterSamples bundle;
    bundle.place = {{0, 0}, 0.2f, true};
    bundle.texels = {{1.0f, {}}};
    bundle.sums.assign(7, 0.0f);
    const OpaqueShadow& opaque = require_opaque_shadow("variance");
    for (const auto& [depth, weight] : {std::pair(-0.9f, 0.5f), std::pair(0.1f, 0.5f)}) {
        bundle.opaque.push_back({depth, weight});
        for (std::size_t k = 0; k < 4; ++k) bundle.texel[k] += weight * opaque.texel(depth)[k];
    }
    const LightBreakdown breakdown = light_breakdown(bundle, light_configuration({}), opaque);
    EXPECT_EQ(breakdown.true_shadowed, 1);
    EXPECT_LT(breakdown.shadowed, 0.9);
    EXPECT_NE(breakdown.sentence.find("light leaks past opaque casters"), std::string::npos)
        << breakdown.sentence;
}

TEST(ShadowOnset, OfTheTruthIsAStep) {
    ViewRay ray;
    ray.warp = {DepthWarp::Kind::linear, 1, 3};
    for (int i = 0; i < 20; ++i) {
        const float depth = -0.9f + 0.09f * static_cast<float>(i);
        ray.fragments.push_back({depth, 2 + depth, 0.06f});
    }
    ray.fragments.push_back({0.1f, 2.1f, 0.94f});
    ray.fragments.back().draw = 1;
    const ShadowOnset truth = shadow_onset(ray, 1, {&require_technique("sorted"), {}});
    EXPECT_FLOAT_EQ(truth.caster, 2.1f);
    EXPECT_NEAR(truth.low, 2.1f, 1e-3f);
    EXPECT_NEAR(truth.length(), 0, 1e-6f);
    const ShadowOnset fourier = shadow_onset(ray, 1, {&require_technique("fourier"), {}});
    EXPECT_LT(fourier.low, 2.0f);
    EXPECT_GT(fourier.length(), 0.1f);
}

// A caster as thin as mist: its shadow rises evenly over its depths, so it reaches a tenth and nine tenths at
// a tenth and nine tenths of the depths.
TEST(ShadowOnset, TakesATenthAndNineTenths) {
    ViewRay ray;
    ray.warp = {DepthWarp::Kind::linear, 1, 3};
    for (int i = 0; i < 1000; ++i) {
        const float depth = -0.5f + 1e-3f * static_cast<float>(i);
        ray.fragments.push_back({depth, 2 + depth, 1e-4f});
        ray.fragments.back().draw = 7;
    }
    const ShadowOnset onset = shadow_onset(ray, 7, {&require_technique("sorted"), {}});
    EXPECT_NEAR(onset.low, 1.6f, 0.01f);  // a total absorption of a tenth bends the ramp by half a percent
    EXPECT_NEAR(onset.high, 2.4f, 0.01f);
    EXPECT_NEAR(onset.caster, 2.0f, 1e-3f);
}

TEST(CastLight, MultipliesWhatItMeets) {
    Scene scene;
    Mesh sheet;
    sheet.positions = {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}};
    sheet.normals.assign(4, {0, 1, 0});
    sheet.indices = {0, 1, 2, 0, 2, 3};
    sheet.texture_coordinates = {{0.25f, 0.5f}, {0.25f, 0.5f}, {0.25f, 0.5f}, {0.25f, 0.5f}};
    scene.meshes.push_back(sheet);
    scene.alpha_maps.push_back({2, 1, {51, 255}});
    const auto at = [](float y) { return glm::mat4({1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, y, 0, 1}); };
    scene.objects.push_back({0, at(1), glm::vec3(1), 0.5f});
    scene.objects.push_back({0, at(2), glm::vec3(1), 0.5f, 0U});  // a fifth of that
    const glm::vec3 from(0.2f, 0, 0.3f), to(0.2f, 5, 0.3f);
    EXPECT_NEAR(cast_light(scene, from, to, 1e-3f).transmittance, 0.5 * 0.9, 1e-6);
    EXPECT_NEAR(cast_light(scene, glm::vec3(0.2f, 1, 0.3f), to, 1e-3f).transmittance, 0.9, 1e-6)
        << "a surface does not shadow itself";
    EXPECT_NEAR(cast_light(scene, from, glm::vec3(0.2f, 1.5f, 0.3f), 1e-3f).transmittance, 0.5, 1e-6)
        << "what lies behind the light does not count";
    EXPECT_EQ(cast_light(scene, glm::vec3(3, 0, 0), glm::vec3(3, 5, 0), 1e-3f).transmittance, 1);
    EXPECT_FALSE(cast_light(scene, from, to, 1e-3f).shadowed);
    scene.objects.push_back({0, at(3), glm::vec3(1), 1.0f});
    EXPECT_TRUE(cast_light(scene, from, to, 1e-3f).shadowed);
    scene.objects.back().casts_shadow = false;
    EXPECT_FALSE(cast_light(scene, from, to, 1e-3f).shadowed);
}

}  // namespace
}  // namespace momentscope::test
