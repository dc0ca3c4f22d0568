#include "core/scene/surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace momentscope {
namespace {

glm::vec3 normal_at(const Surface& surface, float u, float v) {
    constexpr float STEP = 1e-3f;
    const auto between = [](float x) { return std::clamp(x, 0.0f, 1.0f); };
    const glm::vec3 along_u = surface(between(u + STEP), v) - surface(between(u - STEP), v);
    const glm::vec3 along_v = surface(u, between(v + STEP)) - surface(u, between(v - STEP));
    const glm::vec3 across = glm::cross(along_u, along_v);
    const float length = glm::length(across);
    if (length > 1e-12f) return across / length;
    // The edge is a point. Slightly inside there is a surface.
    const float inside_u = glm::mix(u, 0.5f, 0.02f), inside_v = glm::mix(v, 0.5f, 0.02f);
    return inside_u == u && inside_v == v ? glm::vec3(0, 1, 0) : normal_at(surface, inside_u, inside_v);
}

}  // namespace

void add_surface(Mesh& mesh, int columns, int rows, const Surface& surface) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            const float u = float(column) / float(columns), v = float(row) / float(rows);
            mesh.positions.push_back(surface(u, v));
            mesh.normals.push_back(normal_at(surface, u, v));
            mesh.texture_coordinates.emplace_back(u, v);
        }
    }
    const auto stride = static_cast<std::uint32_t>(columns + 1);
    for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(rows); ++row) {
        for (std::uint32_t column = 0; column < static_cast<std::uint32_t>(columns); ++column) {
            const std::uint32_t a = first + row * stride + column;
            const std::uint32_t c = a + stride;
            mesh.indices.insert(mesh.indices.end(), {a, a + 1, c + 1, a, c + 1, c});
        }
    }
}

void add_tube(Mesh& mesh, const glm::vec3& from, const glm::vec3& to, float radius_from, float radius_to,
              int sides) {
    const glm::vec3 along = glm::normalize(to - from);
    const glm::vec3 aside = std::abs(along.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 x = glm::normalize(glm::cross(aside, along));
    const glm::vec3 y = glm::cross(along, x);
    add_surface(mesh, sides, 1, [&](float u, float v) {
        const float angle = u < 1.0f ? glm::two_pi<float>() * u : 0.0f;  // the ends have the same bits
        const glm::vec3 outward = std::cos(angle) * x + std::sin(angle) * y;
        return glm::mix(from, to, v) + glm::mix(radius_from, radius_to, v) * outward;
    });
}

void add_revolved(Mesh& mesh, const glm::vec3& foot, const std::function<glm::vec2(float)>& profile,
                  int slices, int rows) {
    add_surface(mesh, slices, rows, [&](float u, float v) {
        const float angle = u < 1.0f ? glm::two_pi<float>() * u : 0.0f;
        const glm::vec2 at = profile(v);
        return foot + glm::vec3(at.x * std::sin(angle), at.y, at.x * std::cos(angle));
    });
}

}  // namespace momentscope
