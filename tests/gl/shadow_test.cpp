// shadow_test.cpp -- the light that reaches a receiver on the GL equals the value that C++ computes from the
// captured light ray; deep shadow maps and cast rays are compared as the truth.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/compare/difference.hpp"
#include "core/gl/gl_info.hpp"
#include "core/inspect/curve.hpp"
#include "core/ray/random_ray.hpp"
#include "core/render/view_from_light.hpp"
#include "core/shadow/cast_ray.hpp"
#include "tests/effort.hpp"
#include "tests/gl/gl_fixture.hpp"

namespace momentscope::test {
namespace {

constexpr glm::ivec2 SHADOW_SIZE(192, 108);

ParameterValues shadows_with(const ParameterSettings& settings = {}) {
    ParameterSettings all = {{ParameterId::shadows, 1}, {ParameterId::shadow_size, 256}};
    all.insert(all.end(), settings.begin(), settings.end());
    return values_with(all);
}

float choice(ParameterId id, std::string_view name) {
    return *parse_parameter(parameter(id), name);
}

// zink over Mesa 22's lavapipe crashes where a shader has shadow maps and a list of fragments (docs/gl.md).
bool lists_crash() {
    const GlInfo info = gl_info(shared_programs()->gl());
    return info.software && info.renderer.starts_with("zink");
}

class ShadowTest : public GlTest<testing::Test> {
protected:
    void SetUp() override {
        GlTest::SetUp();
        renderer_.emplace(lists_crash() ? without_storage() : shared_programs());
    }

    void show(const char* scene, const ParameterValues& values, const char* technique = "power4-32") {
        if (scene_.id != scene) {
            scene_ = load_scene(scene, 0.4f);
            renderer_->set_scene(scene_);
        }
        renderer_->render({scene_.camera, SHADOW_SIZE, &require_technique(technique), values});
    }

    /// Random receivers in the current picture, opaque and transparent.
    std::vector<LightView> receivers(std::size_t count) {
        RandomNumbers random(3);
        std::vector<LightView> views;
        for (int tries = 0; views.size() < count && tries < 4000; ++tries) {
            const glm::ivec2 pixel(random.whole(0, SHADOW_SIZE.x - 1), random.whole(0, SHADOW_SIZE.y - 1));
            const PixelCapture eye = renderer_->capture_pixel(pixel);
            std::optional<std::size_t> fragment = OPAQUE_SURFACE;
            if (tries % 2 == 0 && !eye.ray.fragments.empty())
                fragment =
                    static_cast<std::size_t>(random.whole(0, static_cast<int>(eye.ray.fragments.size()) - 1));
            auto view = view_from_light(*renderer_, pixel, eye, fragment);
            if (view && view->bundle.place.within) views.push_back(std::move(*view));
        }
        return views;
    }

    Scene scene_;
    std::optional<Renderer> renderer_;  // declared after the context that it needs
};

// The place of a receiver is computed again from the pixel and the view depth. Rounding moves it by 1e-6 of
// the distance, so interpolated moments differ in their last digits. With the bias of Table 1, this changes
// the result of a reconstruction by less than 1e-2, and nearly always by less than 1e-3. Eight moments with
// the bias of Chebyshev moments magnify it twice as much.
TEST_F(ShadowTest, GlIsWhatCppComputesOfTheBundle) {
    for (const char* scene : {"cloud", "ship", "teapots"}) {
        const auto compare = [&](const char* id, std::size_t count) {
            show(scene,
                 shadows_with(
                     {{ParameterId::shadow_technique, choice(ParameterId::shadow_technique, id)},
                      {ParameterId::opaque_shadow, choice(ParameterId::opaque_shadow, "hamburger-32")}}));
            const std::vector<LightView> views = receivers(count);
            ASSERT_EQ(views.size(), count) << scene;
            std::vector<double> off;
            double darkest = 1;
            for (const LightView& view : views) {
                const double cpp = (1 - view.breakdown.shadowed) * view.breakdown.transmittance;
                off.push_back(std::abs(cpp - view.visibility));
                darkest = std::min(darkest, view.visibility);
            }
            std::ranges::sort(off);
            fmt::print("{} {}: median {:.1e}, 95 % {:.1e}, worst {:.1e}; darkest {:.2f}\n", scene, id,
                       off[count / 2], off[count * 95 / 100], off.back(), darkest);
            EXPECT_LT(off[count / 2], 1e-5) << scene << ' ' << id;
            EXPECT_LT(off[count * 95 / 100], 2e-3) << scene << ' ' << id;
            EXPECT_LT(off.back(), 1e-2) << scene << ' ' << id;
            EXPECT_LT(darkest, 0.9) << "there are shadows";
        };
        compare("power6-32", static_cast<std::size_t>(effort(60, 200)));
        for (const char* id : {"power4-32", "trig3-32", "cheb8-32", "fourier-15"})
            compare(id, static_cast<std::size_t>(effort(10, 20)));
    }
}

// The filtered numbers of the map are the weighted sum of the captured fragments: the mixed ray has the
// moments of the map.
TEST_F(ShadowTest, TheMixedRayHasTheMomentsOfTheMap) {
    show("cloud", shadows_with());
    int compared = 0;
    for (const LightView& view : receivers(50)) {
        const Technique& technique = *view.configuration.technique;
        const MomentVector sum =
            sum_moments(view.ray, technique, resolve(view.configuration.values, technique));
        const std::vector<float>& map = view.bundle.sums;
        const float size = std::max(map[0], 1e-3f);
        EXPECT_NEAR(map[0] / size, sum.b0 / size, 2e-5f);
        for (std::size_t k = 0; k + 1 < map.size(); ++k)
            EXPECT_NEAR(map[k + 1] / size, sum.b[k] / size, 2e-5f);
        compared += map[0] > 0.1f ? 1 : 0;
    }
    EXPECT_GT(compared, 20);
}

TEST_F(ShadowTest, EveryOpaqueMapIsWhatCppComputes) {
    for (const OpaqueShadow& row : opaque_shadows()) {
        show("teapots",
             shadows_with({{ParameterId::opaque_shadow, choice(ParameterId::opaque_shadow, row.id)}}));
        double worst = 0, most = 0;
        for (const LightView& view : receivers(12)) {
            if (view.fragment) continue;
            const double cpp = (1 - view.breakdown.shadowed) * view.breakdown.transmittance;
            worst = std::max(worst, std::abs(cpp - view.visibility));
            most = std::max(most, view.breakdown.shadowed);
        }
        fmt::print("{}: off by {:.1e} at most, shadowed {:.2f} at most\n", row.id, worst, most);
        EXPECT_LT(worst, row.bits == 16 ? 2e-2 : 5e-3) << row.id;
    }
}

// For receivers in shadow. With a filter radius of 0, a deep shadow map differs from cast rays only if the
// middle of a texel sees something other than the receiver does.
TEST_F(ShadowTest, DeepMapsAgreeWithRays) {
    constexpr std::size_t RECEIVERS = 100;
    for (const char* id : {"cloud", "ship", "teapots"}) {
        show(id, shadows_with({{ParameterId::shadow_technique, choice(ParameterId::shadow_technique, "deep")},
                               {ParameterId::shadow_radius, 0},
                               {ParameterId::shadow_size, 1024},
                               {ParameterId::opaque_shadow, choice(ParameterId::opaque_shadow, "pcf")}}));
        const LightCamera& frame = renderer_->shadow_maps()->frame();
        std::vector<double> off;
        RandomNumbers random(4);
        for (int tries = 0; off.size() < RECEIVERS && tries < 4000; ++tries) {
            const glm::ivec2 pixel(random.whole(0, SHADOW_SIZE.x - 1), random.whole(0, SHADOW_SIZE.y - 1));
            const auto surface = renderer_->lit_surface(pixel);
            if (!surface) continue;
            const ShadowFilterSamples bundle = renderer_->capture_light(pixel, surface->view_depth);
            if (!bundle.place.within) continue;
            const CastLight cast = cast_light(scene_, renderer_->world_place(pixel, surface->view_depth),
                                              frame.position, LIGHT_SLACK);
            const double truth = cast.shadowed ? 0 : cast.transmittance;
            const auto shown = static_cast<double>((1 - surface->shadowed) * surface->transmittance);
            if (std::min(truth, shown) > 0.95) continue;  // a lit receiver says little
            off.push_back(std::abs(truth - shown));
        }
        ASSERT_EQ(off.size(), RECEIVERS) << id;
        std::ranges::sort(off);
        fmt::print("{}: median {:.1e}, 75 % {:.1e}, worst {:.1e}\n", id, off[RECEIVERS / 2],
                   off[RECEIVERS * 3 / 4], off.back());
        EXPECT_LT(off[RECEIVERS / 2], 5e-3) << id;
        EXPECT_LT(off[RECEIVERS * 3 / 4], 0.1) << id;
    }
}

// With beta = 0 light leaks. With the paper's 0.5, six moments are about as close to the truth as Fourier
// opacity mapping, in the scene that suits the latter best (Section 7.2).
TEST_F(ShadowTest, PicturesAreCloseToThatOfADeepMap) {
    const auto picture = [&](const char* id, float beta) {
        show("cloud",
             shadows_with({{ParameterId::shadow_technique, choice(ParameterId::shadow_technique, id)},
                           {ParameterId::shadow_beta, beta}}),
             "sorted");
        return renderer_->read_picture();
    };
    const Image deep = picture("deep", 0);
    const double fourier = mean_difference(deep, picture("fourier-7", 0), Metric::rmse);
    const double leaking = mean_difference(deep, picture("power6-32", 0), Metric::rmse);
    const double moments = mean_difference(deep, picture("power6-32", 0.5f), Metric::rmse);
    fmt::print("against a deep map: fourier-7 {:.4f}, power6-32 {:.4f}, at beta = 0.5 {:.4f}\n", fourier,
               leaking, moments);
    EXPECT_LT(fourier, 4e-3);
    EXPECT_LT(leaking, 1.5e-2);
    EXPECT_LT(moments, 4e-3);
    EXPECT_GT(moments, 1e-4) << "else something is compared with itself";
}

// Two ground truths that shade in different passes. The fragments of this scene never tie.
TEST_F(ShadowTest, PeelingShadesAsSortedDoes) {
    const auto picture = [&](const char* technique) {
        show("spheres", shadows_with(), technique);
        return renderer_->read_picture();
    };
    const Image sorted = picture("sorted");
    EXPECT_LT(mean_difference(sorted, picture("peeling"), Metric::rmse), 1e-4);
    if (const auto why = why_unavailable(require_technique("mlab"), renderer_->gl()); !why.empty())
        GTEST_SKIP() << why;
    EXPECT_LT(mean_difference(sorted, picture("mlab"), Metric::rmse), 1e-3) << "four layers in half floats";
}

// Every pass that shades must use the light; otherwise half of the surfaces would be lit from beside the
// camera.
TEST_F(ShadowTest, EveryTechniqueReceivesThem) {
    show("spheres", shadows_with(), "sorted");
    const Image truth = renderer_->read_picture();
    show("spheres", values_with({}), "sorted");
    const double unlit = mean_difference(truth, renderer_->read_picture(), Metric::rmse);
    for (const Technique& technique : techniques()) {
        if (!why_unavailable(technique, renderer_->gl()).empty()) continue;
        show("spheres", values_with({}), technique.id);
        const Image before = renderer_->read_picture();
        show("spheres", shadows_with(), technique.id);
        EXPECT_GT(mean_difference(before, renderer_->read_picture(), Metric::rmse), 0.5 * unlit)
            << technique.id;
    }
}

// A change runs only the stages that it needs, of the maps' four stages and of the picture's.
TEST_F(ShadowTest, ChangesRedrawWhatTheyMust) {
    const auto after = [&](ParameterId id, std::optional<float> value) {
        ParameterValues values = shadows_with();
        values.set(id, value);
        const auto runs = [&] {
            const ShadowStages& maps = renderer_->shadow_maps()->stages();
            const PassCounts& passes = renderer_->pass_counts();
            return std::array{maps.opaque_render.runs,
                              maps.opaque_filter.runs,
                              maps.transparent_render.runs,
                              maps.transparent_filter.runs,
                              passes.opaque,
                              passes.moments,
                              passes.color,
                              passes.composite};
        };
        show("cloud", shadows_with());
        const auto before = runs();
        show("cloud", values);
        auto now = runs();
        for (std::size_t i = 0; i < now.size(); ++i) now[i] -= before[i];
        return now;
    };
    using Runs = std::array<int, 8>;
    EXPECT_EQ(after(ParameterId::shadow_beta, 0.5f), (Runs{0, 0, 0, 0, 1, 0, 1, 1}));
    EXPECT_EQ(after(ParameterId::alpha, 1e-3f), (Runs{0, 0, 0, 0, 1, 0, 1, 1}));
    EXPECT_EQ(after(ParameterId::shadow_radius, 2), (Runs{0, 1, 0, 1, 1, 0, 1, 1}));
    EXPECT_EQ(after(ParameterId::opaque_shadow, 0), (Runs{0, 1, 0, 0, 1, 0, 1, 1}));
    EXPECT_EQ(after(ParameterId::shadow_technique, 0), (Runs{0, 0, 1, 1, 1, 0, 1, 1}));
    EXPECT_EQ(after(ParameterId::light_azimuth, 1), (Runs{1, 1, 1, 1, 1, 0, 1, 1}));
    EXPECT_EQ(after(ParameterId::shadow_size, 128), (Runs{1, 1, 1, 1, 1, 0, 1, 1}));
    EXPECT_EQ(after(ParameterId::beta, 0.5f), (Runs{0, 0, 0, 0, 0, 0, 1, 1}));
    EXPECT_EQ(after(ParameterId::renormalize, 0), (Runs{0, 0, 0, 0, 0, 0, 0, 1}));
}

TEST_F(ShadowTest, WithoutShadowsNothingChanges) {
    show("cloud", values_with({}));
    const Image before = renderer_->read_picture();
    show("cloud", shadows_with());
    EXPECT_GT(mean_difference(before, renderer_->read_picture(), Metric::rmse), 1e-2);
    show("cloud", values_with({{ParameterId::shadow_beta, 1}}));
    EXPECT_EQ(mean_difference(before, renderer_->read_picture(), Metric::rmse), 0);
}

TEST_F(ShadowTest, WhatCannotBeDrawnIsRefusedAndTheRendererGoesOn) {
    const auto message = [&](const ParameterSettings& settings) {
        try {
            show("cloud", shadows_with(settings));
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_NE(message({{ParameterId::light_distance, 1}}).find("--light-distance of"), std::string::npos);
    EXPECT_NE(message({{ParameterId::shadow_size, 65536}}).find("--shadow-size"), std::string::npos);
    EXPECT_NE(message({{ParameterId::shadow_size, 16384}}).find("MB"), std::string::npos);
    EXPECT_EQ(message({}), "");
}

}  // namespace
}  // namespace momentscope::test
