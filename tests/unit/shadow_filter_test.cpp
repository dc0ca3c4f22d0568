// shadow_filter_test.cpp -- the light's frustum and its filter.
#include "core/shadow/shadow_filter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include "core/ray/random_ray.hpp"
#include "core/scene/scenes.hpp"
#include "core/shadow/light_camera.hpp"
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

}  // namespace
}  // namespace momentscope::test
