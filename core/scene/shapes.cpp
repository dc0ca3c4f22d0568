// shapes.cpp -- rectangle, sphere, curtain and column by formula; triangles are counter-clockwise from
// outside.
#include "core/scene/shapes.hpp"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <glm/gtc/constants.hpp>

namespace momentscope {
namespace {

/// Adds two triangles for each cell of a grid. Its vertices are stored row by row, with columns + 1 in each
/// row.
void add_grid_indices(Mesh& mesh, int columns, int rows) {
    const auto stride = static_cast<std::uint32_t>(columns + 1);
    for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(rows); ++row) {
        for (std::uint32_t column = 0; column < static_cast<std::uint32_t>(columns); ++column) {
            const std::uint32_t a = row * stride + column;  // lower left; b is lower right, c is above a
            const std::uint32_t b = a + 1;
            const std::uint32_t c = a + stride;
            mesh.indices.insert(mesh.indices.end(), {a, b, c + 1, a, c + 1, c});
        }
    }
}

}  // namespace

Mesh make_rectangle(float width, float height, int columns, int rows) {
    assert(width > 0.0f && height > 0.0f && columns >= 1 && rows >= 1);
    Mesh mesh;
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            const float x = (float(column) / float(columns) - 0.5f) * width;
            const float y = (float(row) / float(rows) - 0.5f) * height;
            mesh.positions.emplace_back(x, y, 0.0f);
            mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
        }
    }
    add_grid_indices(mesh, columns, rows);
    return mesh;
}

// One vertex at each pole and no repeated vertices at the seam, so the surface is closed. The first and the
// last stack are triangles, the others quadrilaterals.
Mesh make_sphere(int slices, int stacks) {
    assert(slices >= 3 && stacks >= 2);
    Mesh mesh;
    const auto count = static_cast<std::uint32_t>(slices);
    const auto rings = static_cast<std::uint32_t>(stacks - 1);
    mesh.positions.emplace_back(0.0f, 1.0f, 0.0f);
    for (std::uint32_t ring = 0; ring < rings; ++ring) {
        const double polar = glm::pi<double>() * (ring + 1) / stacks;
        for (std::uint32_t slice = 0; slice < count; ++slice) {
            const double around = glm::two_pi<double>() * slice / slices;
            mesh.positions.emplace_back(std::sin(polar) * std::sin(around), std::cos(polar),
                                        std::sin(polar) * std::cos(around));
        }
    }
    mesh.positions.emplace_back(0.0f, -1.0f, 0.0f);
    mesh.normals = mesh.positions;

    const std::uint32_t last = 1 + rings * count;
    const auto at = [&](std::uint32_t ring, std::uint32_t slice) { return 1 + ring * count + slice % count; };
    for (std::uint32_t slice = 0; slice < count; ++slice) {
        mesh.indices.insert(mesh.indices.end(), {0, at(0, slice), at(0, slice + 1)});
        for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
            const std::uint32_t a = at(ring, slice), b = at(ring + 1, slice);
            const std::uint32_t c = at(ring + 1, slice + 1), d = at(ring, slice + 1);
            mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
        }
        mesh.indices.insert(mesh.indices.end(), {at(rings - 1, slice), last, at(rings - 1, slice + 1)});
    }
    return mesh;
}

Mesh make_curtain(float width, float height, int folds, float amplitude) {
    assert(folds >= 0 && std::isfinite(amplitude));
    constexpr int COLUMNS_PER_FOLD = 16;  // 16 sides per wave look smooth with smooth normals
    Mesh mesh = make_rectangle(width, height, folds == 0 ? 1 : COLUMNS_PER_FOLD * folds, 1);
    const float frequency = glm::two_pi<float>() * float(folds) / width;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const float phase = frequency * mesh.positions[i].x;
        const float slope = amplitude * frequency * std::cos(phase);  // dz/dx
        mesh.positions[i].z = amplitude * std::sin(phase);
        mesh.normals[i] = glm::normalize(glm::vec3(-slope, 0.0f, 1.0f));
    }
    return mesh;
}

Mesh make_column(float radius, float height, int slices) {
    assert(radius > 0.0f && slices >= 3);
    Mesh mesh = make_rectangle(1.0f, height, slices, 1);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        // The two ends of the seam must have the same bits, or there would be a crack.
        const bool seam = i % static_cast<std::size_t>(slices + 1) == static_cast<std::size_t>(slices);
        const float angle = seam ? -glm::pi<float>() : glm::two_pi<float>() * mesh.positions[i].x;
        const glm::vec3 outward(std::sin(angle), 0.0f, std::cos(angle));
        mesh.positions[i] = radius * outward + glm::vec3(0.0f, mesh.positions[i].y + 0.5f * height, 0.0f);
        mesh.normals[i] = outward;
    }
    return mesh;
}

}  // namespace momentscope
