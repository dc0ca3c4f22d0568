// cloud_scene.cpp -- a cloud of particles with a dense disk in it, after Fig. 2 and 9 of the paper.
#include "core/scene/billboards.hpp"
#include "core/scene/builtin_scenes.hpp"

namespace momentscope {

namespace {

constexpr int PARTICLES = 600;
constexpr int CORNERS = 10;  // of the outline of a particle

}  // namespace

Scene build_cloud() {
    Scene scene;
    scene.id = "cloud";
    scene.camera = {glm::vec3(0.0f, 0.1f, 0.0f), 6.0f, 0.3f, 0.15f, 0.8f};
    scene.light = {-0.5f, 1.2f};
    scene.background = linear_color(0x9DB8D2);
    scene.picked = {0.5f, 0.5f};
    const glm::vec3 facing = towards_camera(scene.camera);
    const glm::vec3 extent(2.2f, 1.1f, 1.2f);
    RandomNumbers random(7);
    Mesh particles;
    for (int i = 0; i < PARTICLES; ++i) {
        const glm::vec3 place = in_unit_ball(random);
        const float radius = random.uniform(0.2f, 0.5f);
        const glm::vec3 normal = glm::normalize(place / extent + 0.3f * facing);
        add_billboard(particles, {place * extent, radius, facing, normal}, CORNERS);
    }
    scene.objects.push_back({add_mesh(scene, std::move(particles)), glm::mat4(1), glm::vec3(0.92f), 0.06f});
    Mesh disk;
    const glm::vec3 tilted = glm::normalize(facing + glm::vec3(0.5f, 0.6f, 0.0f));
    add_billboard(disk, {glm::vec3(0.1f, 0.0f, 0.0f), 0.6f, tilted, tilted}, CORNERS);
    scene.objects.push_back({add_mesh(scene, std::move(disk)), glm::mat4(1), linear_color(0xC8321E), 0.94f});
    add_ground(scene, 30.0f, -1.8f);
    return scene;
}

}  // namespace momentscope
