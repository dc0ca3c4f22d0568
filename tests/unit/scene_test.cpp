// scene_test.cpp -- shapes, bounds and the built-in scenes; mesh_file_test.cpp covers files.
#include "core/scene/billboards.hpp"
#include "core/scene/builtin_scenes.hpp"
#include "core/scene/scenes.hpp"
#include "core/scene/shapes.hpp"
#include "core/scene/surfaces.hpp"
#include "core/support/error.hpp"
#include "tests/unit/mesh_checks.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <set>
#include <string>

using namespace momentscope;

namespace {

/// The signed volume by the divergence theorem; positive if the winding is outward.
double volume(const Mesh& mesh) {
    double sum = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) { return glm::dvec3(mesh.positions[mesh.indices[i + k]]); };
        sum += glm::dot(corner(0), glm::cross(corner(1), corner(2))) / 6.0;
    }
    return sum;
}

/// Directed edges without an opposite edge: the rims of holes. Fails if an edge occurs twice.
int border_edges(const Mesh& mesh) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const bool is_new = edges.insert({mesh.indices[i + k], mesh.indices[i + (k + 1) % 3]}).second;
            EXPECT_TRUE(is_new) << "two triangles run along an edge in the same direction";
        }
    }
    int borders = 0;
    for (const auto& [from, to] : edges) borders += edges.contains({to, from}) ? 0 : 1;
    return borders;
}

bool finite(const glm::vec3& v) {
    return std::isfinite(v.x + v.y + v.z);
}

TEST(Shapes, RectangleIsFlatFacesForwardAndHasItsArea) {
    const Mesh mesh = make_rectangle(3.0f, 2.0f, 4, 5);
    expect_well_formed(mesh);
    EXPECT_EQ(mesh.positions.size(), 30u);
    EXPECT_EQ(mesh.indices.size(), 3u * 2 * 4 * 5);
    EXPECT_EQ(agreeing_triangles(mesh), 1.0);
    EXPECT_EQ(extent_of(mesh).low, glm::vec3(-1.5f, -1.0f, 0.0f));
    EXPECT_EQ(extent_of(mesh).high, glm::vec3(1.5f, 1.0f, 0.0f));
    EXPECT_EQ(border_edges(mesh), 2 * (4 + 5));
}

TEST(Shapes, SphereIsClosedOutwardAndRound) {
    for (const auto& [slices, stacks] : {std::pair{3, 2}, std::pair{16, 8}, std::pair{96, 48}}) {
        const Mesh mesh = make_sphere(slices, stacks);
        expect_well_formed(mesh);
        EXPECT_EQ(agreeing_triangles(mesh), 1.0);
        EXPECT_EQ(border_edges(mesh), 0);
        // Euler: V - E + F = 2, and in a closed triangle mesh E = 3 F / 2.
        const auto faces = static_cast<long>(mesh.indices.size() / 3);
        EXPECT_EQ(static_cast<long>(mesh.positions.size()) - faces / 2, 2);
        for (const glm::vec3& position : mesh.positions) EXPECT_NEAR(glm::length(position), 1.0f, 1e-6f);
    }
    // An inscribed polyhedron with steps of 1/15 rad lacks at most about (1/15)^2 / 2 of the volume.
    EXPECT_NEAR(volume(make_sphere(96, 48)), 4.18879, 0.012);
}

TEST(Shapes, CurtainWavesAsAsked) {
    const Mesh mesh = make_curtain(4.0f, 2.0f, 3, 0.25f);
    expect_well_formed(mesh);
    EXPECT_EQ(agreeing_triangles(mesh), 1.0);
    EXPECT_NEAR(extent_of(mesh).high.z, 0.25f, 1e-6f);
    EXPECT_NEAR(extent_of(mesh).low.z, -0.25f, 1e-6f);
    // A normal is perpendicular to the central difference of its neighbours, except for the cubic term.
    for (std::size_t i = 1; i < 48; ++i) {
        const glm::vec3 along = glm::normalize(mesh.positions[i + 1] - mesh.positions[i - 1]);
        EXPECT_NEAR(glm::dot(along, mesh.normals[i]), 0.0f, 0.02f);
    }
    expect_well_formed(make_curtain(1.0f, 1.0f, 0, 0.5f));
}

TEST(Shapes, ColumnStandsOnTheGroundWithoutASeam) {
    const Mesh mesh = make_column(0.5f, 3.0f, 12);
    expect_well_formed(mesh);
    EXPECT_EQ(agreeing_triangles(mesh), 1.0);
    EXPECT_EQ(extent_of(mesh).low.y, 0.0f);
    EXPECT_EQ(extent_of(mesh).high.y, 3.0f);
    EXPECT_EQ(mesh.positions[0], mesh.positions[12]);
    EXPECT_EQ(mesh.positions[13], mesh.positions[25]);
}

TEST(Surfaces, FaceAlongUCrossV) {
    Mesh mesh;
    add_surface(mesh, 3, 2, [](float u, float v) { return glm::vec3(u, v, 0.1f * u * v); });
    add_tube(mesh, {1, 2, 3}, {-2, 5, 3}, 0.3f, 0.1f, 7);
    add_tube(mesh, {0, 0, 0}, {0, 2, 0}, 0.3f, 0.3f, 7);
    const auto cone = [](float along) { return glm::vec2(along < 1.0f ? 1.0f - along : 0.0f, along); };
    add_revolved(mesh, {4, 0, 0}, cone, 8, 4);
    expect_well_formed(mesh);
    EXPECT_EQ(agreeing_triangles(mesh), 1.0);
    EXPECT_EQ(mesh.texture_coordinates.size(), mesh.positions.size());
    EXPECT_EQ(mesh.texture_coordinates[3], glm::vec2(1, 0));
    EXPECT_EQ(mesh.positions[3], glm::vec3(1, 0, 0));
    // From index 12 on: the first tube. Each of its points lies at the radius from the axis, with a normal
    // that points away.
    for (std::size_t i = 12; i < 12 + 2 * 8; ++i) {
        const glm::vec3 axis = glm::normalize(glm::vec3(-3, 3, 0));
        const glm::vec3 from = mesh.positions[i] - glm::vec3(1, 2, 3);
        const glm::vec3 outward = from - glm::dot(from, axis) * axis;
        EXPECT_NEAR(glm::length(outward), i < 20 ? 0.3f : 0.1f, 1e-5f);
        EXPECT_GT(glm::dot(glm::normalize(outward), mesh.normals[i]), 0.95f);
    }
}

TEST(Billboards, FaceTheCameraWithTheirMapAroundThem) {
    Mesh mesh;
    const glm::vec3 facing = glm::normalize(glm::vec3(1, 0.5f, 2));
    add_billboard(mesh, {glm::vec3(1, 2, 3), 0.5f, facing, glm::vec3(0, 1, 0), 0.7f}, 8);
    expect_well_formed(mesh);
    EXPECT_EQ(mesh.indices.size(), 18u);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_NEAR(glm::distance(mesh.positions[i], glm::vec3(1, 2, 3)), 0.5f, 1e-6f);
        EXPECT_NEAR(glm::dot(mesh.positions[i] - glm::vec3(1, 2, 3), facing), 0.0f, 1e-6f);
        EXPECT_NEAR(glm::distance(mesh.texture_coordinates[i], glm::vec2(0.5f)), 0.5f, 1e-6f);
    }
    const AlphaMap puff = make_puff(3);
    for (int x = 0; x < puff.width; ++x) EXPECT_EQ(puff.bytes[static_cast<std::size_t>(x)], 0);
}

TEST(Teapot, HasNewellsMeasures) {
    const Mesh mesh = make_teapot(16);
    expect_well_formed(mesh);
    const Extent extent = extent_of(mesh);
    EXPECT_EQ(extent.low.y, 0.0f);
    EXPECT_EQ(extent.high.y, 1.575f);  // 3.15 / 2
    EXPECT_EQ(extent.low.x, -1.5f);    // the handle's outermost control points lie on it
    EXPECT_NEAR(extent.high.x, 1.717f, 0.001f);
    // Only the body reaches this far to the sides; cubics with 0.56 / 1 make a circle within 0.2 %.
    EXPECT_NEAR(extent.high.z, 1.0f, 1e-6f);
    EXPECT_NEAR(extent.low.z, -1.0f, 1e-6f);
}

TEST(Teapot, FacesOutwardsEverywhere) {
    for (const int divisions : {3, 10, 18}) {
        const Mesh mesh = make_teapot(divisions);
        expect_well_formed(mesh);
        EXPECT_EQ(agreeing_triangles(mesh), 1.0) << divisions;
        EXPECT_GT(volume(mesh), 2.9);
    }
    expect_well_formed(make_teapot(1));
    // Known directions: the knob's top, the base's middle, the body's front and back.
    const Mesh mesh = make_teapot(8);
    int found = 0;
    const auto expect_facing = [&](std::size_t i, const glm::vec3& direction) {
        EXPECT_GT(glm::dot(mesh.normals[i], direction), 0.9f);
        ++found;
    };
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3 p = mesh.positions[i];
        if (p == glm::vec3(0.0f, 1.575f, 0.0f)) expect_facing(i, {0.0f, 1.0f, 0.0f});
        if (p == glm::vec3(0.0f)) expect_facing(i, {0.0f, -1.0f, 0.0f});
        if (p.x == 0.0f && std::abs(p.z) == 1.0f) expect_facing(i, p);
    }
    EXPECT_GE(found, 4);
}

TEST(Teapot, HasNoCracks) {
    // 32 patches have 2 n^2 triangles each; the 8 patches at the poles lose n each. The two ends of handle
    // and spout (2 n edges each), the inside of the rim and the edge of the lid (4 n edges each) are open.
    for (const int n : {4, 7, 18}) {
        const Mesh mesh = make_teapot(n);
        EXPECT_EQ(mesh.indices.size() / 3, static_cast<std::size_t>(64 * n * n - 8 * n));
        EXPECT_EQ(border_edges(mesh), 16 * n);
    }
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
