// smoke_scene.cpp -- glass bottles in grass and dense smoke, after the scenes of Moment Transparency (Sharpe
// 2018).
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <utility>

#include "core/scene/billboards.hpp"
#include "core/scene/builtin_scenes.hpp"
#include "core/scene/surfaces.hpp"

namespace momentscope {
namespace {

constexpr int BLADES = 1300;
constexpr int SMOKE_PUFFS = 72;
constexpr std::array<std::uint32_t, 3> GRASS{0x7F9A4A, 0x5E7F3A, 0xA39A56};

struct Bottle {
    glm::vec3 foot;
    float scale;
    float shoulder;  // height at which the neck begins, as a share of the whole height
    std::uint32_t glass;
    std::uint32_t liquid;
    float filled;  // height of the liquid, as a share of the whole height
};
constexpr std::array<Bottle, 6> BOTTLES{{
    {{-1.15f, 0.0f, 0.35f}, 1.25f, 0.62f, 0x3F7A4B, 0x5B1420, 0.5f},
    {{-0.35f, 0.0f, -0.2f}, 1.5f, 0.68f, 0xB8CDD0, 0xC08A2E, 0.42f},
    {{0.35f, 0.0f, 0.45f}, 1.1f, 0.5f, 0x8A4E1E, 0x4A2A12, 0.36f},
    {{0.95f, 0.0f, -0.4f}, 1.4f, 0.6f, 0x3E5F9A, 0xA9C4D8, 0.3f},
    {{1.6f, 0.0f, 0.3f}, 1.2f, 0.66f, 0x5C9C7A, 0x6B8F3A, 0.55f},
    {{-1.9f, 0.0f, -0.6f}, 1.4f, 0.64f, 0xA8612E, 0x7A3B14, 0.6f},
}};

/// The radius at a height in [0, 1] of a bottle of height 1: belly, shoulder, neck and lip.
float radius_at(float height, float shoulder) {
    const float neck = glm::smoothstep(shoulder - 0.08f, shoulder + 0.12f, height);
    const float lip = 0.014f * glm::smoothstep(0.94f, 0.955f, height);
    return glm::mix(0.165f, 0.052f, neck) * std::sqrt(glm::smoothstep(-0.02f, 0.03f, height)) + lip;
}

/// Adds an outer and an inner wall, so that a ray meets glass four times.
void add_glass(Mesh& mesh, const Bottle& bottle) {
    for (const float wall : {0.0f, 0.016f}) {
        add_revolved(
            mesh, bottle.foot,
            [&](float along) {
                const float height = glm::mix(1.2f * wall, 1.0f, along);
                return bottle.scale * glm::vec2(radius_at(height, bottle.shoulder) - wall, height);
            },
            32, 28);
    }
}

void add_liquid(Mesh& mesh, const Bottle& bottle) {
    constexpr float SIDE = 0.85f;  // share of the profile that is the side; the rest is the surface
    add_revolved(
        mesh, bottle.foot,
        [&](float along) {
            const float height = glm::mix(0.025f, bottle.filled, std::min(along / SIDE, 1.0f));
            const float inward = std::max((along - SIDE) / (1 - SIDE), 0.0f);
            const float radius = (radius_at(height, bottle.shoulder) - 0.022f) * (1 - inward);
            return bottle.scale * glm::vec2(radius, height);
        },
        28, 20);
}

void add_blade(Mesh& mesh, RandomNumbers& random) {
    const float away = random.uniform(-2.6f, 1.7f);
    const glm::vec3 root(random.uniform(-3.4f, 3.4f), 0.0f, away);
    const float height = random.uniform(0.25f, 0.8f), width = random.uniform(0.018f, 0.035f);
    const float heading = random.uniform(0.0f, glm::two_pi<float>());
    const glm::vec3 ahead(std::cos(heading), 0.0f, std::sin(heading));
    const glm::vec3 aside(-ahead.z, 0.0f, ahead.x);
    const float bent = random.uniform(0.1f, 0.55f);
    add_surface(mesh, 1, 5, [&](float u, float v) {
        const float half = width * (1.0f - 0.97f * v * v);
        return root + height * (v * glm::vec3(0, 1 - 0.35f * bent * v, 0) + bent * v * v * ahead) +
               (2 * u - 1) * half * aside;
    });
}

// Adds a bank of smoke that drifts from the left, low in front and higher behind.
void add_smoke(Mesh& pale, Mesh& dark, const Camera& camera, RandomNumbers& random) {
    for (int i = 0; i < SMOKE_PUFFS; ++i) {
        const glm::vec3 place = in_unit_ball(random);
        Billboard puff;
        puff.center =
            glm::vec3(3.2f * place.x - 0.3f, 0.85f + 0.7f * place.y - 0.2f * place.x, 1.9f * place.z - 0.9f);
        puff.center.y += 0.35f * std::max(-place.z, 0.0f);
        puff.radius = random.uniform(0.4f, 0.9f);
        puff.facing = towards_camera(camera);
        // Never at right angles to the view: two-sided shading would jump there.
        puff.normal = glm::normalize(0.6f * place + glm::vec3(0.0f, 0.3f, 0.0f) + puff.facing);
        puff.turn = random.uniform(0.0f, glm::two_pi<float>());
        add_billboard(i % 3 == 0 ? dark : pale, puff, 8);
    }
}

}  // namespace

Scene build_smoke() {
    Scene scene;
    scene.id = "smoke";
    scene.camera = {glm::vec3(-0.1f, 0.78f, 0.0f), 6.6f, 0.12f, 0.09f, 0.4f};
    scene.background = linear_color(0xB7C4CC);
    scene.picked = {0.438f, 0.417f};  // smoke in front of, in and behind a bottle
    RandomNumbers random(31);
    const auto add = [&](Mesh mesh, std::uint32_t color, float opacity) {
        scene.objects.push_back(
            {add_mesh(scene, std::move(mesh)), glm::mat4(1), linear_color(color), opacity});
    };
    Mesh pale, dark;
    add_smoke(pale, dark, scene.camera, random);
    const std::uint32_t puff = add_alpha_map(scene, make_puff(9));
    add(std::move(pale), 0xE2E3E0, 0.45f);
    scene.objects.back().alpha_map = puff;
    for (const Bottle& bottle : BOTTLES) {
        Mesh glass, liquid;
        add_glass(glass, bottle);
        add_liquid(liquid, bottle);
        add(std::move(glass), bottle.glass, 0.3f);
        add(std::move(liquid), bottle.liquid, 0.55f);
    }
    std::array<Mesh, GRASS.size()> grass;
    for (int i = 0; i < BLADES; ++i) add_blade(grass[static_cast<std::size_t>(i) % grass.size()], random);
    for (std::size_t i = 0; i < grass.size(); ++i) add(std::move(grass[i]), GRASS[i], 0.9f);
    add(std::move(dark), 0x77767A, 0.4f);
    scene.objects.back().alpha_map = puff;
    add_ground(scene, 400.0f, 0.0f, linear_color(0x75704F));
    return scene;
}

}  // namespace momentscope
