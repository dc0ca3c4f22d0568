// foliage_scene.cpp -- a red teapot in front of alpha-mapped leaves, after the failure case in Fig. 7 of the
// paper.
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "core/ray/random_ray.hpp"
#include "core/scene/billboards.hpp"
#include "core/scene/builtin_scenes.hpp"
#include "core/scene/shapes.hpp"
#include "core/scene/surfaces.hpp"
#include "core/support/error.hpp"

namespace momentscope {
namespace {

constexpr int STEMS = 52;
constexpr int LEAVES_PER_STEM = 48;
constexpr float OPACITY = 0.92f;  // of a leaf where its map is white; some light shines through

// From light to dark: from young to old leaves.
constexpr std::array<std::uint32_t, 4> GREENS{0x9CB452, 0x6E9440, 0x4C7A38, 0x375F33};

/// Adds a leaf that hangs from `stalk` in the direction `along`, folded a little along its middle.
void add_leaf(Mesh& mesh, const glm::vec3& stalk, const glm::vec3& along, const glm::vec3& facing,
              float length) {
    const glm::vec3 aside = glm::normalize(glm::cross(along, facing));
    const glm::vec3 out = glm::cross(aside, along);
    add_surface(mesh, 2, 2, [&](float u, float v) {
        const float across = u - 0.5f;
        const float bend = 0.25f * std::abs(across) - 0.2f * v * v;
        return stalk + length * (v * along + across * aside + bend * out);
    });
}

struct Hedge {
    Mesh stems;
    std::array<Mesh, GREENS.size()> leaves;
};

void add_stem(Hedge& hedge, RandomNumbers& random) {
    const float behind = random.uniform(-3.6f, -1.5f);
    const glm::vec3 root(random.uniform(-4.6f, 4.6f), 0.0f, behind);
    const glm::vec3 top = root + random.point({-0.7f, 1.9f, -0.3f}, {0.7f, 3.3f, 0.5f});
    add_tube(hedge.stems, root, top, 0.035f, 0.01f, 6);
    for (int i = 0; i < LEAVES_PER_STEM; ++i) {
        const float height = std::pow(random.uniform(0.02f, 1.0f), 0.7f);  // fewer near the ground
        const glm::vec3 twig = glm::mix(root, top, height);
        const glm::vec3 away = glm::normalize(in_unit_ball(random) + glm::vec3(0.0f, 0.0f, 0.15f));
        const glm::vec3 stalk = twig + random.uniform(0.05f, 0.42f) * away;
        const glm::vec3 along = glm::normalize(away + glm::vec3(0.0f, random.uniform(-1.2f, 0.3f), 0.0f));
        const glm::vec3 facing = glm::normalize(in_unit_ball(random) + glm::vec3(0.0f, 0.6f, 0.9f));
        const auto shade = static_cast<std::size_t>(random.whole(0, static_cast<int>(GREENS.size()) - 1));
        add_leaf(hedge.leaves[shade], stalk, along, facing, random.uniform(0.26f, 0.46f));
    }
}

}  // namespace

Scene build_foliage() {
    return build_foliage(MOMENTSCOPE_ASSETS "/leaf.png");
}

Scene build_foliage(const std::filesystem::path& leaf) {
    Scene scene;
    scene.id = "foliage";
    scene.camera = {glm::vec3(0.05f, 1.28f, -0.6f), 8.4f, 0.16f, 0.1f, 0.44f};
    scene.background = linear_color(0xC3D4DF);
    scene.picked = {0.459f, 0.677f};  // both walls of the teapot, and leaves behind it
    std::optional<std::uint32_t> map;
    try {
        map = add_alpha_map(scene, read_alpha_map(leaf));
    } catch (const Error& error) {
        scene.warnings.push_back(std::string(error.what()) + " Leaves are drawn as rectangles.");
    }
    RandomNumbers random(11);
    Hedge hedge;
    for (int i = 0; i < STEMS; ++i) add_stem(hedge, random);
    for (std::size_t shade = 0; shade < GREENS.size(); ++shade) {
        const std::uint32_t mesh = add_mesh(scene, std::move(hedge.leaves[shade]));
        scene.objects.push_back({mesh, glm::mat4(1), linear_color(GREENS[shade]), OPACITY, map});
    }
    const glm::mat4 turned = glm::rotate(glm::mat4(1), -0.5f, glm::vec3(0, 1, 0));
    scene.objects.push_back({add_mesh(scene, make_teapot(16)), turned, linear_color(0xC4231B), 0.55f});
    scene.objects.push_back({add_mesh(scene, std::move(hedge.stems)), glm::mat4(1), linear_color(0x6B4F3A)});
    add_ground(scene, 400.0f, 0.0f, linear_color(0xB9AE98));
    return scene;
}

}  // namespace momentscope
