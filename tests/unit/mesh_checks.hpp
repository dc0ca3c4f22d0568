// mesh_checks.hpp -- checks that every mesh must pass, whatever its source.
#pragma once
#include "core/scene/scene.hpp"

#include <gtest/gtest.h>
#include <cmath>

namespace momentscope {

struct Extent {
    glm::vec3 low = glm::vec3(1e30f);
    glm::vec3 high = glm::vec3(-1e30f);
};

inline Extent extent_of(const Mesh& mesh) {
    Extent extent;
    for (const glm::vec3& position : mesh.positions) {
        extent.low = glm::min(extent.low, position);
        extent.high = glm::max(extent.high, position);
    }
    return extent;
}

/// The promises of struct Mesh: indices in range, finite positions, unit normals.
inline void expect_well_formed(const Mesh& mesh) {
    ASSERT_FALSE(mesh.indices.empty());
    ASSERT_EQ(mesh.indices.size() % 3, 0u);
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    if (!mesh.texture_coordinates.empty()) {
        ASSERT_EQ(mesh.texture_coordinates.size(), mesh.positions.size());
    }
    for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.positions.size());
    for (const glm::vec3& p : mesh.positions) ASSERT_TRUE(std::isfinite(p.x + p.y + p.z));
    for (const glm::vec3& n : mesh.normals) ASSERT_NEAR(glm::length(n), 1.0f, 1e-5f);
}

/// The share of triangles with an area whose winding agrees with their vertices' normals.
inline double agreeing_triangles(const Mesh& mesh) {
    double agreeing = 0.0;
    double all = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
        const glm::dvec3 origin(mesh.positions[a]);
        const glm::dvec3 facing =
            glm::cross(glm::dvec3(mesh.positions[b]) - origin, glm::dvec3(mesh.positions[c]) - origin);
        if (glm::length(facing) == 0.0) continue;
        all += 1.0;
        const glm::dvec3 normal(mesh.normals[a] + mesh.normals[b] + mesh.normals[c]);
        agreeing += glm::dot(facing, normal) > 0.0 ? 1.0 : 0.0;
    }
    return agreeing / all;
}

}  // namespace momentscope
