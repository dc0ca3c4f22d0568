// coarse_mesh_test.cpp -- coarse meshes have fewer triangles but the same shape.
#include "core/scene/coarse_mesh.hpp"
#include "core/scene/billboards.hpp"
#include "core/scene/shapes.hpp"
#include "tests/unit/mesh_checks.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <limits>

namespace momentscope::test {
namespace {

float distance_to_segment(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 along = b - a;
    const float length2 = glm::dot(along, along);
    const float t = length2 > 0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0f, 1.0f) : 0.0f;
    return glm::length(p - (a + t * along));
}

/// Distance to the plane of the triangle if the foot point lies within it, otherwise to the nearest edge.
float distance_to_triangle(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::vec3 normal = glm::cross(b - a, c - a);
    const auto inside = [&](const glm::vec3& from, const glm::vec3& to) {
        return glm::dot(glm::cross(to - from, p - from), normal) >= 0;
    };
    if (glm::length(normal) > 0 && inside(a, b) && inside(b, c) && inside(c, a))
        return std::abs(glm::dot(p - a, glm::normalize(normal)));
    return std::min(
        {distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

float distance_to_mesh(const glm::vec3& p, const Mesh& mesh) {
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        least = std::min(least, distance_to_triangle(p, mesh.positions[mesh.indices[i]],
                                                     mesh.positions[mesh.indices[i + 1]],
                                                     mesh.positions[mesh.indices[i + 2]]));
    return least;
}

TEST(CoarseMesh, OfATeapotHasItsShapeWithAQuarterOfItsTriangles) {
    const Mesh fine = make_teapot(18);
    const Mesh coarse = coarse_mesh(fine);
    expect_well_formed(coarse);
    EXPECT_LE(coarse.indices.size(), fine.indices.size() / 4);
    EXPECT_GE(coarse.indices.size(), fine.indices.size() / 6);
    EXPECT_LT(coarse.positions.size(), fine.positions.size() / 2) << "vertices of no triangle are left out";
    EXPECT_GT(agreeing_triangles(coarse), 0.99);
    const Extent extent = extent_of(fine);
    const glm::vec3 size = extent.high - extent.low;
    const float allowed = 0.01f * std::max({size.x, size.y, size.z});
    for (std::size_t i = 0; i < fine.positions.size(); i += 31)
        EXPECT_LE(distance_to_mesh(fine.positions[i], coarse), allowed) << "vertex " << i;
}

TEST(CoarseMesh, KeepsTextureCoordinatesWithTheirVertices) {
    Mesh fine = make_rectangle(2, 2, 60, 60);
    for (const glm::vec3& p : fine.positions) fine.texture_coordinates.emplace_back(p.x, p.y);
    const Mesh coarse = coarse_mesh(fine);
    expect_well_formed(coarse);
    EXPECT_LT(coarse.indices.size(), fine.indices.size() / 3);
    for (std::size_t i = 0; i < coarse.positions.size(); ++i)
        EXPECT_EQ(coarse.texture_coordinates[i], glm::vec2(coarse.positions[i]));
}

TEST(CoarseMesh, IsTheMeshWhereItIsSmallOrOfLooseParts) {
    const Mesh small = make_sphere(12, 8);
    EXPECT_EQ(coarse_mesh(small).indices, small.indices);
    Mesh billboards;
    for (int i = 0; i < 1200; ++i)
        add_billboard(billboards, {.center = {static_cast<float>(i), 0, 0}, .radius = 20.0f}, 4);
    EXPECT_EQ(coarse_mesh(billboards).indices.size(), billboards.indices.size());
    EXPECT_TRUE(coarse_mesh(Mesh()).indices.empty());
}

}  // namespace
}  // namespace momentscope::test
