// builtin_scenes.cpp -- planes, spheres, teapots and ties: scenes after pictures of the paper that need no
// asset.
#include "core/scene/builtin_scenes.hpp"

#include "core/image/image.hpp"
#include "core/scene/camera.hpp"
#include "core/scene/shapes.hpp"

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

namespace momentscope {
namespace {

// The colours of Okabe and Ito, which people with any kind of colour vision can tell apart.
constexpr std::uint32_t ORANGE = 0xE69F00;
constexpr std::uint32_t SKY_BLUE = 0x56B4E9;
constexpr std::uint32_t GREEN = 0x009E73;
constexpr std::uint32_t VERMILION = 0xD55E00;

constexpr glm::vec3 UP(0.0f, 1.0f, 0.0f);

glm::mat4 placed_at(const glm::vec3& position, float turn = 0.0f, float scale = 1.0f) {
    const glm::mat4 moved = glm::translate(glm::mat4(1.0f), position);
    return glm::scale(glm::rotate(moved, turn, UP), glm::vec3(scale));
}

/// The colour of a transparent teapot. The hue turns by the golden angle, so neighbours differ clearly.
glm::vec3 teapot_color(int number) {
    const float hue = glm::two_pi<float>() * std::fmod(0.618034f * float(number), 1.0f);
    const auto wave = [&](float phase) {
        return 0.45f + 0.4f * std::cos(hue - phase * glm::two_pi<float>());
    };
    return {wave(0.0f), 0.8f * wave(1.0f / 3.0f), wave(2.0f / 3.0f)};
}

void add_teapots(Scene& scene) {
    constexpr int COUNT = 17;
    constexpr float SPACING = 2.15f;  // nearly touching, because the diameter of a body is 2
    constexpr int DIVISIONS = 18;     // makes 3.5e5 triangles; Fig. 10 of the paper has 3.6e5
    const std::uint32_t mesh = add_mesh(scene, make_teapot(DIVISIONS));
    for (int i = 0; i < COUNT; ++i) {
        // A fixed shuffle (6 and 17 share no divisor). Teapots are submitted neither back to front nor front
        // to back, so techniques that depend on the order show it.
        const int place = (6 * i + 3) % COUNT;
        const glm::vec3 position(0.0f, 0.0f, -SPACING * float(place));
        const float opacity = 0.4f + 0.025f * float(place % 5);
        scene.objects.push_back({mesh, placed_at(position, -0.6f), teapot_color(place), opacity});
    }
}

void add_curtains(Scene& scene) {
    const std::uint32_t mesh = add_mesh(scene, make_curtain(9.0f, 6.5f, 11, 0.18f));
    scene.objects.push_back({mesh, placed_at({-4.1f, 3.4f, -14.0f}, 0.15f), linear_color(0xB03A48), 0.5f});
    scene.objects.push_back({mesh, placed_at({3.6f, 3.4f, -5.4f}, -0.25f), linear_color(0x3F7F4F), 0.45f});
}

void add_hall(Scene& scene) {
    constexpr float LENGTH = 100.0f;
    add_ground(scene, LENGTH, 0.0f);
    const std::uint32_t wall = add_mesh(scene, make_rectangle(LENGTH, 20.0f, 1, 1));
    scene.objects.push_back({wall, placed_at({0.0f, 10.0f, -45.0f}), linear_color(0xC9B28F)});
    scene.objects.back().casts_shadow =
        false;  // it would widen the frustum of the light for a shadow that nothing receives
    const std::uint32_t column = add_mesh(scene, make_column(0.6f, 12.0f, 48));
    for (int i = 0; i < 4; ++i) {
        for (const float x : {-5.5f, 6.5f}) {
            const glm::vec3 foot(x, 0.0f, -4.0f - 9.0f * float(i));
            scene.objects.push_back({column, placed_at(foot), linear_color(0xD8C7A5)});
        }
    }
}

}  // namespace

glm::vec3 towards_camera(const Camera& camera) {
    return orbit_direction(camera.azimuth, camera.elevation);
}

std::uint32_t add_mesh(Scene& scene, Mesh mesh) {
    scene.meshes.push_back(std::move(mesh));
    return static_cast<std::uint32_t>(scene.meshes.size() - 1);
}

std::uint32_t add_alpha_map(Scene& scene, AlphaMap map) {
    scene.alpha_maps.push_back(std::move(map));
    return static_cast<std::uint32_t>(scene.alpha_maps.size() - 1);
}

void add_ground(Scene& scene, float side, float y) {
    add_ground(scene, side, y, linear_color(0xCFCBC4));
}

void add_ground(Scene& scene, float side, float y, const glm::vec3& color) {
    const std::uint32_t mesh = add_mesh(scene, make_rectangle(side, side, 1, 1));
    const glm::mat4 lowered = placed_at({0.0f, y, 0.0f});
    const glm::mat4 model = glm::rotate(lowered, -glm::half_pi<float>(), glm::vec3(1.0f, 0.0f, 0.0f));
    scene.objects.push_back({mesh, model, color});
    scene.objects.back().casts_shadow = false;
}

glm::vec3 linear_color(std::uint32_t srgb) {
    const auto channel = [&](int shift) { return linear_from_srgb(float((srgb >> shift) & 0xFFu) / 255.0f); };
    return {channel(16), channel(8), channel(0)};
}

// Each sheet lies a step farther right and up than the nearer one. Different parts of the picture show 1, 2,
// 3 and, in the middle, all 4 sheets. There is no fog between them, so the absorbance has exactly 1 to 4
// steps.
Scene build_planes() {
    Scene scene;
    scene.id = "planes";
    scene.camera = {glm::vec3(0.0f), 6.0f, 0.0f, 0.1f, 0.8f};
    scene.picked = {0.5f, 0.5f};  // all four sheets
    const std::uint32_t sheet = add_mesh(scene, make_rectangle(3.6f, 2.4f, 1, 1));
    const std::array<std::pair<std::uint32_t, float>, 4> looks{
        {{ORANGE, 0.3f}, {SKY_BLUE, 0.5f}, {GREEN, 0.4f}, {VERMILION, 0.6f}}};
    for (const int i : {2, 0, 3, 1}) {  // not in order of distance, because the order must not matter
        const float step = float(i) - 1.5f;
        const glm::vec3 position(0.7f * step, 0.36f * step, -step);
        const auto [color, opacity] = looks[static_cast<std::size_t>(i)];
        scene.objects.push_back({sheet, placed_at(position), linear_color(color), opacity});
    }
    const std::uint32_t wall = add_mesh(scene, make_rectangle(30.0f, 16.0f, 1, 1));
    scene.objects.push_back({wall, placed_at({0.0f, 0.0f, -4.0f}), linear_color(0xE4E1DA)});
    return scene;
}

Scene build_spheres() {
    Scene scene;
    scene.id = "spheres";
    scene.camera = {glm::vec3(0.0f), 4.6f, 0.0f, 0.2f, 0.8f};
    scene.picked = {0.47f, 0.48f};  // through all three spheres, near the point where their surfaces meet
    const std::uint32_t sphere = add_mesh(scene, make_sphere(96, 48));
    const std::array<std::uint32_t, 3> colors{0xD9392B, 0x2E9E45, 0x2F66D0};
    for (int i = 0; i < 3; ++i) {
        const float around = glm::two_pi<float>() * float(i) / 3.0f;
        const glm::vec3 center(0.6f * std::sin(around), 0.6f * std::cos(around), 0.0f);
        scene.objects.push_back({sphere, placed_at(center), linear_color(colors[std::size_t(i)]), 0.5f});
    }
    add_ground(scene, 30.0f, -1.35f);
    // The paper enlarges the depth range to more than ten radii, so that the touching surfaces are hard to
    // separate. Here a speck far behind the spheres does this, through transparent_bounds. It lies on the
    // axis of the camera, so the bounds grow away from the camera and not towards the near plane. It also
    // lies beneath the opaque ground, so no pixel shows it.
    const std::uint32_t speck = add_mesh(scene, make_rectangle(0.02f, 0.02f, 1, 1));
    const glm::vec3 far_behind = -22.0f * towards_camera(scene.camera);
    scene.objects.push_back({speck, placed_at(far_behind), glm::vec3(0.5f), 0.002f});
    scene.objects.back().casts_shadow = false;
    return scene;
}

Scene build_teapots() {
    Scene scene;
    scene.id = "teapots";
    // The row runs along -z. The camera is a little beside and above it. So the teapots converge towards the
    // vanishing point near the middle of the picture, where a ray passes through most of them.
    scene.camera = {glm::vec3(0.05f, 0.8f, -5.0f), 12.5f, 0.12f, 0.075f, 0.34f};
    scene.background = linear_color(0xA9C4DE);
    scene.picked = {0.55f, 0.48f};
    add_teapots(scene);
    add_curtains(scene);
    add_hall(scene);
    return scene;
}

// Pairs of sheets that overlap: one at the same depth, one very close and one farther apart. Two more sheets
// cross. At equal depths the order of submission decides what the truth is, so no technique can be right
// about it.
Scene build_ties() {
    Scene scene;
    scene.id = "ties";
    scene.camera = {glm::vec3(0.0f), 6.0f, 0.0f, 0.0f, 0.8f};
    scene.picked = {0.27f, 0.32f};  // two sheets at the same depth
    const std::uint32_t sheet = add_mesh(scene, make_rectangle(1.7f, 1.1f, 1, 1));
    const auto add = [&](const glm::vec3& position, float turn, std::uint32_t color) {
        scene.objects.push_back({sheet, placed_at(position, turn), linear_color(color), 0.6f});
    };
    const std::array<std::pair<glm::vec3, float>, 3> pairs{
        {{{-1.7f, 0.9f, 0.0f}, 0.0f}, {{1.7f, 0.9f, 0.0f}, 1e-3f}, {{-1.7f, -0.9f, 0.0f}, 0.1f}}};
    for (const auto& [corner, apart] : pairs) {
        add(corner + glm::vec3(-0.35f, 0.15f, 0.0f), 0.0f, ORANGE);
        add(corner + glm::vec3(0.35f, -0.15f, apart), 0.0f, SKY_BLUE);
    }
    add({1.7f, -0.9f, 0.0f}, 0.5f, ORANGE);
    add({1.7f, -0.9f, 0.0f}, -0.5f, SKY_BLUE);
    const std::uint32_t wall = add_mesh(scene, make_rectangle(30.0f, 16.0f, 1, 1));
    scene.objects.push_back({wall, placed_at({0.0f, 0.0f, -3.0f}), linear_color(0xE4E1DA)});
    return scene;
}

}  // namespace momentscope
