// scene_test.cpp -- bounds and the built-in scenes; shapes_test.cpp covers shapes, mesh_file_test.cpp files.
#include "core/scene/builtin_scenes.hpp"
#include "core/scene/scenes.hpp"
#include "core/scene/shapes.hpp"
#include "core/support/error.hpp"
#include "tests/unit/mesh_checks.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <set>
#include <string>

using namespace momentscope;

namespace {

bool finite(const glm::vec3& v) {
    return std::isfinite(v.x + v.y + v.z);
}

TEST(Bounds, ContainEveryTransparentVertexAndNoOpaqueOne) {
    for (const SceneEntry& entry : scene_entries()) {
        const Scene scene = entry.build();
        const Sphere bounds = transparent_bounds(scene);
        EXPECT_TRUE(finite(bounds.center) && std::isfinite(bounds.radius));
        for (const Object& object : scene.objects) {
            if (object.opaque()) continue;
            for (const glm::vec3& position : scene.meshes[object.mesh].positions) {
                const glm::vec3 world(object.model * glm::vec4(position, 1.0f));
                ASSERT_LE(glm::distance(world, bounds.center), bounds.radius) << entry.id;
            }
        }
    }
    Scene scene;
    EXPECT_EQ(transparent_bounds(scene).radius, 0.0f);
    scene.meshes.push_back(make_sphere(8, 4));
    scene.objects.push_back({0, glm::mat4(1.0f), glm::vec3(1.0f), 1.0f});
    EXPECT_EQ(transparent_bounds(scene).radius, 0.0f);
    const glm::mat4 moved = glm::translate(glm::mat4(1.0f), glm::vec3(5.0f, 0.0f, 0.0f));
    scene.objects.push_back({0, glm::scale(moved, glm::vec3(2.0f)), glm::vec3(1.0f), 0.5f});
    EXPECT_NEAR(transparent_bounds(scene).radius, 2.0f, 1e-5f);
    EXPECT_NEAR(transparent_bounds(scene).center.x, 5.0f, 1e-5f);
}

TEST(Scenes, AreWellFormed) {
    std::set<std::string> ids;
    for (const SceneEntry& entry : scene_entries()) {
        SCOPED_TRACE(entry.id);
        EXPECT_TRUE(ids.insert(entry.id).second);
        EXPECT_EQ(std::string(entry.description).back(), '.');
        const Scene scene = load_scene(entry.id, 0.5f);
        EXPECT_EQ(scene.id, entry.id);
        for (const Mesh& mesh : scene.meshes) expect_well_formed(mesh);
        int transparent = 0;
        for (const Object& object : scene.objects) {
            ASSERT_LT(object.mesh, scene.meshes.size());
            if (object.alpha_map) {
                ASSERT_LT(*object.alpha_map, scene.alpha_maps.size());
                EXPECT_FALSE(scene.meshes[object.mesh].texture_coordinates.empty());
            }
            EXPECT_TRUE(finite(object.color) && glm::all(glm::greaterThanEqual(object.color, glm::vec3(0))));
            EXPECT_TRUE(object.opacity > 0.0f && object.opacity <= 1.0f);
            for (int column = 0; column < 4; ++column) EXPECT_TRUE(finite(glm::vec3(object.model[column])));
            transparent += object.opaque() ? 0 : 1;
        }
        for (const AlphaMap& map : scene.alpha_maps)
            EXPECT_EQ(map.bytes.size(), static_cast<std::size_t>(map.width) * std::size_t(map.height));
        EXPECT_TRUE(scene.warnings.empty());
        EXPECT_GT(transparent, 0);
        EXPECT_LT(transparent, static_cast<int>(scene.objects.size()));
        EXPECT_TRUE(glm::all(glm::greaterThan(scene.picked, glm::vec2(0.0f))));
        EXPECT_TRUE(glm::all(glm::lessThan(scene.picked, glm::vec2(1.0f))));
    }
    EXPECT_EQ(ids, (std::set<std::string>{"planes", "spheres", "teapots", "ties", "cloud", "foliage", "ship",
                                          "smoke"}));
}

TEST(Scenes, FollowThePaper) {
    // Fig. 8: a depth range of more than ten radii (of 1) that does not contain the camera.
    const Scene spheres = load_scene("spheres", 0.5f);
    const Sphere bounds = transparent_bounds(spheres);
    const Camera& camera = spheres.camera;
    const glm::vec3 direction(std::sin(camera.azimuth) * std::cos(camera.elevation),
                              std::sin(camera.elevation),
                              std::cos(camera.azimuth) * std::cos(camera.elevation));
    const float to_center = glm::distance(camera.target + camera.distance * direction, bounds.center);
    EXPECT_GT(bounds.radius, 10.0f);
    EXPECT_GT(to_center - bounds.radius, 1.0f);

    // Fig. 6 and 10: 17 teapots, two curtains, 3.6e5 transparent triangles.
    const Scene teapots = load_scene("teapots", 0.5f);
    std::size_t triangles = 0;
    std::size_t objects = 0;
    for (const Object& object : teapots.objects) {
        if (object.opaque()) continue;
        triangles += teapots.meshes[object.mesh].indices.size() / 3;
        ++objects;
    }
    EXPECT_EQ(objects, 19u);
    EXPECT_NEAR(static_cast<double>(triangles), 3.6e5, 0.1e5);
}

TEST(Scenes, TeapotsAreNotSubmittedInOrder) {
    const Scene scene = load_scene("teapots", 0.5f);
    int nearer = 0;
    int farther = 0;
    for (std::size_t i = 1; i < 17; ++i)
        ++(scene.objects[i].model[3].z > scene.objects[i - 1].model[3].z ? nearer : farther);
    EXPECT_GT(nearer, 3);
    EXPECT_GT(farther, 3);
}

TEST(Scenes, TheCloudIsTheSameOnEveryMachine) {
    const Scene scene = load_scene("cloud", 0.5f);
    const Mesh& particles = scene.meshes[scene.objects[0].mesh];
    EXPECT_EQ(particles.positions.size(), 6000u);
    EXPECT_EQ(load_scene("cloud", 0.5f).meshes[0].positions, particles.positions);
    EXPECT_EQ(scene.objects[1].opacity, 0.94f);
}

/// Numbers that do not depend on the machine's sine: how much there is of everything, and where it is.
TEST(Scenes, LargeOnesAreTheSameEveryTimeAndBearable) {
    for (const char* id : {"foliage", "ship", "smoke"}) {
        SCOPED_TRACE(id);
        const Scene scene = load_scene(id, 0.5f), again = load_scene(id, 0.5f);
        std::size_t triangles = 0;
        ASSERT_EQ(scene.meshes.size(), again.meshes.size());
        for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
            EXPECT_EQ(scene.meshes[i].positions, again.meshes[i].positions);
            triangles += scene.meshes[i].indices.size() / 3;
        }
        EXPECT_LT(triangles, 60'000u);
        ASSERT_EQ(scene.alpha_maps.size(), 1u);
        EXPECT_EQ(scene.alpha_maps[0].bytes, again.alpha_maps[0].bytes);
        const auto [least, most] = std::ranges::minmax(scene.alpha_maps[0].bytes);
        EXPECT_EQ(least, 0);  // the map cuts something out
        EXPECT_GT(most, 150);
    }
}

TEST(Scenes, FoliageWithoutItsLeafIsDrawnWithRectangles) {
    const std::filesystem::path broken = std::filesystem::temp_directory_path() / "momentscope-leaf.png";
    std::ofstream(broken) << "no picture";
    for (const std::filesystem::path& path : {std::filesystem::path("/nowhere/leaf.png"), broken}) {
        const Scene scene = build_foliage(path);
        ASSERT_EQ(scene.warnings.size(), 1u);
        EXPECT_NE(scene.warnings[0].find(path.string()), std::string::npos) << scene.warnings[0];
        EXPECT_EQ(scene.warnings[0].back(), '.');
        EXPECT_EQ(scene.warnings[0].find('\n'), std::string::npos);
        EXPECT_EQ(scene.objects.size(), build_foliage().objects.size());
        for (const Object& object : scene.objects) EXPECT_FALSE(object.alpha_map);
    }
    std::filesystem::remove(broken);
}

TEST(Scenes, UnknownNameListsTheIds) {
    try {
        load_scene("xyz", 0.5f);
        FAIL() << "xyz is no scene";
    } catch (const Error& error) {
        EXPECT_STREQ(
            error.what(),
            "There is no scene 'xyz'; use one of planes, spheres, teapots, ties, cloud, foliage, ship, smoke, or the path of a mesh file.");
    }
    EXPECT_THROW(load_scene("", 0.5f), Error);
    EXPECT_THROW(load_scene(std::string(100'000, 'x'), 0.5f), Error);
}

}  // namespace
