// shapes_test.cpp -- shapes, surfaces, billboards and the teapot.
#include "core/scene/shapes.hpp"
#include "core/scene/billboards.hpp"
#include "core/scene/surfaces.hpp"
#include "tests/unit/mesh_checks.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <set>
#include <utility>

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

}  // namespace
