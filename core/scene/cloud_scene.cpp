// cloud_scene.cpp -- a cloud of particles with a dense disk in it: what the paper's Fig. 2 and 9 look at.
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "core/ray/random_ray.hpp"
#include "core/scene/builtin_scenes.hpp"

namespace momentscope {

namespace {

constexpr int PARTICLES = 600;
constexpr int CORNERS = 10;  // of a particle's outline

glm::vec3 in_unit_ball(RandomNumbers& random) {
    while (true) {
        const glm::vec3 point(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        if (glm::length(point) < 1) return point;
    }
}

// A flat disk across `facing`, shaded as the surface of the cloud is there.
void add_particle(Mesh& mesh, const glm::vec3& center, float radius, const glm::vec3& facing,
                  const glm::vec3& normal) {
    const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), facing));
    const glm::vec3 up = glm::cross(facing, right);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int i = 0; i < CORNERS; ++i) {
        const float angle = glm::two_pi<float>() * static_cast<float>(i) / CORNERS;
        mesh.positions.push_back(center + radius * (std::cos(angle) * right + std::sin(angle) * up));
        mesh.normals.push_back(normal);
    }
    for (std::uint32_t i = 2; i < CORNERS; ++i)
        mesh.indices.insert(mesh.indices.end(), {first, first + i - 1, first + i});
}

}  // namespace

Scene build_cloud() {
    Scene scene;
    scene.id = "cloud";
    scene.camera = {glm::vec3(0.0f, 0.1f, 0.0f), 6.0f, 0.3f, 0.15f, 0.8f};
    scene.background = linear_color(0x9DB8D2);
    scene.picked = {0.5f, 0.5f};
    const glm::vec3 facing = towards_camera(scene.camera);
    const glm::vec3 extent(2.2f, 1.1f, 1.2f);
    RandomNumbers random(7);
    Mesh particles;
    for (int i = 0; i < PARTICLES; ++i) {
        const glm::vec3 place = in_unit_ball(random);
        const float radius = random.uniform(0.2f, 0.5f);
        add_particle(particles, place * extent, radius, facing,
                     glm::normalize(place / extent + 0.3f * facing));
    }
    scene.objects.push_back({add_mesh(scene, std::move(particles)), glm::mat4(1), glm::vec3(0.92f), 0.06f});
    Mesh disk;
    const glm::vec3 tilted = glm::normalize(facing + glm::vec3(0.5f, 0.6f, 0.0f));
    add_particle(disk, glm::vec3(0.1f, 0.0f, 0.0f), 0.6f, tilted, tilted);
    scene.objects.push_back({add_mesh(scene, std::move(disk)), glm::mat4(1), linear_color(0xC8321E), 0.94f});
    add_ground(scene, 30.0f, -1.8f);
    return scene;
}

}  // namespace momentscope
