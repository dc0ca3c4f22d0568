// shadow_test.cpp -- mixtures of texels, rays to the light, and the sentences about receivers.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "core/inspect/curve.hpp"
#include "core/ray/random_ray.hpp"
#include "core/shadow/cast_ray.hpp"
#include "core/shadow/light_breakdown.hpp"
#include "core/shadow/shadow_onset.hpp"

namespace momentscope::test {
namespace {

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

// A caster that also receives light does not shadow itself, whatever beta is.
TEST(LightTransmittance, LeavesOutTheReceiverItself) {
    RandomNumbers random(6);
    for (const float beta : {0.0f, 0.5f, 1.0f}) {
        const Configuration configuration = {&require_technique("power6-32"),
                                             values_with({{ParameterId::beta, beta}})};
        ViewRay sheet;
        sheet.fragments = {plain_fragment(0.2f, 0.6f, 0)};
        ShadowFilterSamples alone = bundle_of(sheet, configuration, 0.2f);
        alone.receiver_absorbance = fragment_absorbance(0.6f);
        EXPECT_NEAR(light_transmittance(alone, configuration, 0.2f), 1, 1e-4f) << "beta " << beta;
        for (int i = 0; i < 20; ++i) {
            const ViewRay ray = random_ray(random, 6, 0.1f, 0.5f);
            ShadowFilterSamples bundle = bundle_of(ray, configuration, ray.fragments[3].depth);
            const float shadowed = light_transmittance(bundle, configuration, ray.fragments[3].depth);
            bundle.receiver_absorbance = fragment_absorbance(ray.fragments[3].opacity);
            EXPECT_GE(light_transmittance(bundle, configuration, ray.fragments[3].depth), shadowed - 1e-6f);
        }
    }
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
